#include "app/window/preview/preview_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/preview/judged_state.h"
#include "app/window/preview/options_text.h"
#include "app/window/preview/reconstruct_flow.h"
#include "core/pipeline/pipeline_options.h"
#include "core/pipeline/region_preview.h"
#include "core/pipeline/registry.h"
#include "ui/document/plant_document.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr Eigen::Index ballPoints = 20000; // what is shown at once
constexpr int resting = 250;               // [ms] without a change: the hand rests

bool isOfPoints(const Step& step) {
  return step.makes <= StepResult::contracted;
}

Outcome outcomeOf(RegionPreview region, const Ball& ball, const PipelineOptions& options,
                  const PointCloud& cloud) {
  return {.options = options,
          .contracted = std::make_shared<const Eigen::Matrix3Xf>(std::move(region.contracted)),
          .scanned = std::make_shared<const Eigen::Matrix3Xf>(
              cloud.positions()(Eigen::all, region.points)),
          .points = region.points,
          .skeleton = std::make_shared<const Skeleton>(std::move(region.skeleton)),
          .within = ball,
          .quality = nullptr};
}

} // namespace

PlantState Outcome::shownAs(const QString& name) const {
  return {.name = name,
          .contracted = contracted,
          .scanned = scanned,
          .points = points,
          .skeleton = *skeleton,
          .colors = std::nullopt,
          .within = within};
}

PreviewFlow::PreviewFlow(const Parts& parts) : parts_(parts) {
  addActions();
  rest_.setSingleShot(true);
  rest_.setInterval(resting);
  connect(&rest_, &QTimer::timeout, this, [this] {
    isAllOwed_ = job_.isBusy(); // then once it is done
    if (!isAllOwed_) askAll();
  });
  connect(&job_, &JobSlot::finished, this, [this] {
    if (isAllOwed_) askAll();
  });
  connect(&job_, &JobSlot::failed, this, [this](const QString& message) {
    rest_.stop();
    isAll_ = isAllOwed_ = false;
    parts_.pipeline.showFailed(message);
    hasFailed_ = true;
    emit failed(message);
    emit changed();
  });
  connect(&job_, &JobSlot::progressed, this, [this](double, const QString& stage) {
    if (isAll_) parts_.pipeline.showRunning(stage);
  });
  connect(&parts_.pipeline, &PipelinePanel::changed, this, [this](const Step& step) {
    if (isDropping_) return;
    if (!isLive()) return askAgain();
    ask(isOfPoints(step));
  });
  connect(&parts_.reconstruct, &ReconstructFlow::done, this, [this] {
    clear();
    keepChoices();
  });
  connect(&parts_.reconstruct, &ReconstructFlow::usedChanged, this, [this] {
    if (shown_) show(*shown_); // it may do something otherwise than the plant now
  });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged})
    connect(&parts_.document, signal, this, [this] {
      forgetScan();
      QTimer::singleShot(0, this, [this] { // once one looks at it
        if (isLive() && !shown_ && !isComing()) askFirst();
      });
    });
  keepChoices();
  connect(this, &PreviewFlow::changed, this, &PreviewFlow::hintChanged);
}

PreviewFlow::~PreviewFlow() = default;

void PreviewFlow::addActions() {
  parts_.actions.beginSection(tr("Preview"));
  QAction* live = parts_.actions.add({.id = "live_preview",
                                      .text = tr("Live Preview"),
                                      .help = tr("Shows what each change of a step would make"),
                                      .keys = QKeySequence(Qt::CTRL | Qt::Key_L),
                                      .isCheckable = true,
                                      .menu = "preview/live"},
                                     {});
  connect(live, &QAction::toggled, &parts_.pipeline, &PipelinePanel::setLive);
  connect(&parts_.pipeline, &PipelinePanel::liveToggled, live, &QAction::setChecked);
  connect(live, &QAction::toggled, this, &PreviewFlow::turn);
  parts_.actions.add({.id = "preview_here",
                      .text = tr("Preview Here"),
                      .help = tr("Shows changes at once in the points under the pointer; on empty "
                                 "ground: where one looks, as usual"),
                      .keys = QKeySequence(Qt::SHIFT | Qt::Key_L),
                      .menu = "preview/live"},
                     [this] { placeBall(); });
}

bool PreviewFlow::isLive() const {
  return parts_.actions["live_preview"]->isChecked();
}

void PreviewFlow::turn(bool isOn) {
  if (isOn && parts_.document.scan() != nullptr) return askFirst();
  clear();
  keepChoices();
}

PipelineOptions PreviewFlow::options() const {
  PipelineOptions options = parts_.pipeline.options();
  options.leftOut = parts_.document.leftOut();
  return options;
}

Eigen::Vector3d PreviewFlow::center() const {
  if (placed_) return *placed_;
  const PlantView& view = parts_.editing.activeView();
  const Pick seen = view.pick(view.rect().center());
  return seen.point ? *seen.point : parts_.document.scan()->onPoints(view.camera().focus);
}

void PreviewFlow::placeBall() {
  placed_ = parts_.editing.under().point;
  if (!isLive())
    parts_.actions["live_preview"]->setChecked(true); // asks
  else
    ask(movesPoints_);
}

void PreviewFlow::ask(bool movesPoints) {
  const Scan* scan = parts_.document.scan();
  if (scan == nullptr) return;
  if (isAll_) parts_.pipeline.showStopped();
  isAll_ = isAllOwed_ = false;
  movesPoints_ = movesPoints;
  rest_.start();
  if (scan->cloud()->size() <= ballPoints) return askAll();
  makePreviewer();
  if (movesPoints)
    askContracted();
  else
    askReconstructed();
}

/// It is of the whole scan, and kept as long as that stands as it does.
void PreviewFlow::makePreviewer() {
  const PipelineOptions now = options();
  if (previewer_ && previewed_.root == now.root && previewed_.up == now.up) return;
  previewed_ = now;
  previewer_ = std::make_shared<const RegionPreviewer>(parts_.document.scan()->cloud(), now.leftOut,
                                                       parts_.document.scale(), now.up, now.root);
}

/// Points are shown where they were scanned until their contraction is another.
void PreviewFlow::askFirst() {
  const PipelineOptions used = parts_.reconstruct.used();
  ask(std::ranges::any_of(pipelineSteps(), [&](const Step& step) {
    return isOfPoints(step) && !isSameIn(step, options(), used);
  }));
}

void PreviewFlow::askAgain() {
  if (isLive())
    ask(true);
  else
    keepChoices();
}

void PreviewFlow::askContracted() {
  begin(
      Kind::contracted,
      [previewer = previewer_, cloud = parts_.document.scan()->cloud(), options = options(),
       center = center()](const Progress& progress) {
        const Ball ball = previewer->ballWith(center, ballPoints);
        return outcomeOf(previewer->contracted(ball, options, progress), ball, options, *cloud);
      },
      [this](Outcome outcome) {
        if (shown_ && shown_->within == outcome.within) // until there is a new one
          outcome.skeleton = shown_->skeleton;
        show(outcome);
        if (!job_.isWaiting()) askReconstructed();
      });
}

void PreviewFlow::askReconstructed() {
  const Scan& scan = *parts_.document.scan();
  begin(
      Kind::reconstructed,
      [previewer = previewer_, cloud = scan.cloud(), spacing = scan.spacing(), options = options(),
       center = center()](const Progress& progress) {
        const Ball ball = previewer->ballWith(center, ballPoints);
        Outcome outcome =
            outcomeOf(previewer->reconstructed(ball, options, progress), ball, options, *cloud);
        outcome.quality = judged(outcome, *cloud, spacing, nullptr, {}, progress).quality;
        return outcome;
      },
      [this](const Outcome& outcome) {
        show(outcome);
        if (!rest_.isActive() && !job_.isWaiting()) askAll();
      });
}

void PreviewFlow::askAll() {
  rest_.stop();
  isAllOwed_ = false;
  isAll_ = true;
  const Scan& scan = *parts_.document.scan();
  running_ = Kind::whole;
  job_.start(
      [pipeline = parts_.reconstruct.pipeline(), cloud = scan.cloud(), spacing = scan.spacing(),
       options = options()](const Progress& progress) {
        const Reconstruction made = pipeline->run(cloud, options, progress.part(0, 0.9));
        Outcome outcome{.options = options,
                        .contracted = made.contracted,
                        .scanned = nullptr,
                        .skeleton = made.skeleton,
                        .within = std::nullopt,
                        .quality = nullptr};
        outcome.quality =
            judged(outcome, *cloud, spacing, nullptr, {}, progress.part(0.9, 1)).quality;
        return outcome;
      },
      [this](const Outcome& outcome) {
        isAll_ = false;
        parts_.pipeline.showDone(parts_.reconstruct.stepTexts());
        show(outcome);
      });
}

void PreviewFlow::show(const Outcome& outcome) {
  if (std::exchange(hasFailed_, false)) emit outdated();
  shown_ = outcome;
  drawn_.reset();
  draw();
  emit changed();
}

void PreviewFlow::setDrawn(std::optional<Drawn> drawn) {
  if (!shown_ || (!drawn && !drawn_)) return;
  drawn_ = std::move(drawn);
  draw();
}

bool PreviewFlow::isOther() const {
  const PipelineOptions used = parts_.reconstruct.used();
  return parts_.document.skeleton().isEmpty() || used.leftOut != shown_->options.leftOut ||
         !changeBetween(used, shown_->options).isEmpty();
}

void PreviewFlow::draw() {
  if (!isOther()) return parts_.view.setState(Side::right, std::nullopt);
  PlantState state = shown_->shownAs(name());
  if (drawn_) {
    state.skeleton = drawn_->skeleton;
    state.colors = drawn_->colors;
  }
  state.replacesPoints = movesPoints_;
  parts_.view.setState(Side::right, state);
}

QString PreviewFlow::name() const {
  const QString change = changeBetween(parts_.reconstruct.used(), shown_->options);
  const QString name = change.isEmpty() ? tr("Preview") : change;
  return shown_->within ? tr("%1 · in the circle").arg(name) : name;
}

QString PreviewFlow::changeBetween(const PipelineOptions& before,
                                   const PipelineOptions& after) const {
  return changeText(before, after, parts_.document.scale(), symbol(parts_.document.unit()));
}

void PreviewFlow::keepChoices() {
  before_ = parts_.pipeline.options();
}

bool PreviewFlow::drop() {
  if (!shown_) return false;
  if (isOther()) dropChoices();
  clear();
  parts_.reconstruct.showUsed();
  return true;
}

void PreviewFlow::dropChoices() {
  if (const QString change = changeBetween(before_, parts_.pipeline.options()); !change.isEmpty())
    emit noted(tr("Dropped: %1").arg(change)); // it can be typed again
  isDropping_ = true;
  parts_.document.setUp(before_.up);
  parts_.document.setRoot(before_.root);
  isDropping_ = false;
  parts_.pipeline.setOptions(before_);
}

void PreviewFlow::setEnabled(bool isEnabled) {
  if (isEnabled)
    goOn();
  else
    stop();
}

QString PreviewFlow::hint() const {
  if (!shown_ || !isOther() || parts_.editing.isPending()) return {};
  return withKeys(tr("Preview   {reconstruct} make it the skeleton   {leave} drop it   "
                     "{keep_as_a} keep as A"),
                  parts_.actions);
}

bool PreviewFlow::isComing() const {
  return rest_.isActive() || (job_.isBusy() && !job_.isCanceled());
}

void PreviewFlow::goOn() {
  const bool hasScan = parts_.document.scan() != nullptr; // what is shown may be of one that closes
  if (hasScan && isLive() && shown_ && shown_->within && !isComing()) askAll();
}

void PreviewFlow::stop() {
  job_.cancel();
  rest_.stop();
  if (isAll_) parts_.pipeline.showStopped();
  isAll_ = isAllOwed_ = false;
}

void PreviewFlow::clear() {
  stop();
  hasFailed_ = false;
  if (!shown_) return;
  shown_.reset();
  parts_.view.setState(Side::right, std::nullopt);
  emit changed();
}

void PreviewFlow::forgetScan() {
  clear();
  previewer_.reset();
  placed_.reset();
  keepChoices(); // root and up are of the scan
}

} // namespace espalier
