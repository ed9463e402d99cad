#include "app/window/align/registration_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/files/file_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "core/align/target_sphere.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "ui/document/plant_document.h"
#include "ui/panels/registration_panel.h"
#include "ui/tools/screen_plane.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>

#include <cmath>
#include <utility>

namespace espalier {
namespace {

/// Where a scan is shown at first: as it is, or, if that is beside the open one, on its middle.
Eigen::Isometry3d firstMotion(const Eigen::AlignedBox3d& moved, const Eigen::AlignedBox3d& fixed) {
  if (moved.intersects(fixed)) return Eigen::Isometry3d::Identity();
  return Eigen::Isometry3d(Eigen::Translation3d(fixed.center() - moved.center()));
}

} // namespace

RegistrationFlow::RegistrationFlow(const Parts& parts)
    : parts_(parts), sphere_(parts.jobs.queue(), JobPriority::hand),
      distances_(parts.jobs.queue(), JobPriority::asked) {
  addActions();
  connect(panel_, &RegistrationPanel::removeRequested, this, [this](int pair) {
    change([&] { registration_.removePair(static_cast<std::size_t>(pair)); });
  });
  connect(&parts_.document, &PlantDocument::scanChanged, this, [this] {
    lastMotion_.reset();
    end();
  });
  connect(&parts_.document, &PlantDocument::unitChanged, this, &RegistrationFlow::show);
  connect(&sphere_, &JobSlot::failed, this, &WindowPart::failed);
  connect(&distances_, &JobSlot::failed, this, &WindowPart::failed);
  show();
}

void RegistrationFlow::begin(const QString& path) {
  parts_.jobs.requireIdle();
  if (parts_.document.scan() == nullptr)
    throw Error(tr("there is no scan to register another one to: open one first").toStdString());
  if (!mayLose()) return;
  if (formatOf(toPath(path)).content != Content::points)
    throw Error(path.toStdString() + ": holds no points: choose another scan of this plant");
  parts_.files.readOther(path, [this](LoadedFiles files) { takeScan(std::move(files)); });
}

void RegistrationFlow::takeScan(LoadedFiles files) {
  const Scan* open = parts_.document.scan();
  if (open == nullptr) return;
  end();
  other_ = std::move(files.scan);
  path_ = files.scanPath;
  isPart_ = files.part.isPart();
  registration_ = ScanRegistration(firstMotion(other_->bounds(), open->bounds()));
  parts_.editing.borrow([this](const ToolInput& input) { return handle(input); });
  parts_.window.actions["layer_points"]->setChecked(true);
  show();
  emit begun();
  dock_->bringToFront();
  parts_.view.frameAll();
  if (!files.notes.isEmpty()) emit reported({.text = files.notes.join('\n')});
}

void RegistrationFlow::removeLast() {
  if (hasWork()) change([&] { registration_.removeLast(); });
}

void RegistrationFlow::escape() {
  if (registration_.pending())
    removeLast();
  else
    leave();
}

void RegistrationFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refreshActions();
}

void RegistrationFlow::setPlantShown(bool /*isShown*/) {
  refreshActions();
}

QString RegistrationFlow::hint() const {
  if (!isActive() || !isEnabled_) return {};
  return nextText() + withKeys(tr("   Drag: turn   {remove_last_target} take back   {leave} leave"),
                               parts_.window.actions);
}

/// A click picks; drags turn the view.
bool RegistrationFlow::handle(const ToolInput& input) {
  using Phase = ToolInput::Phase;
  if (input.phase == Phase::hover) {
    Preview preview;
    if (const auto place = placeOf(input.pick)) preview.nodes = {*place};
    parts_.editing.activeView().showPreview(isEnabled_ ? preview : Preview());
  }
  if (input.phase == Phase::press) {
    press_.reset();
    if (input.button == Qt::LeftButton && input.modifiers == Qt::NoModifier) press_ = input.screen;
  }
  if (input.phase == Phase::drag && press_ && isDragged(*press_, input.screen)) press_.reset();
  if (input.phase == Phase::cancel) press_.reset();
  if (input.phase == Phase::release && std::exchange(press_, {}) && isEnabled_) click(input.pick);
  return false;
}

/// Where a point of the scan that is asked for is drawn.
std::optional<Eigen::Vector3d> RegistrationFlow::placeOf(const Pick& pick) const {
  if (registration_.wantsFixed()) return pick.point;
  if (!pick.movedPoint) return std::nullopt;
  return registration_.motion() * other_->cloud()->position(*pick.movedPoint);
}

void RegistrationFlow::click(const Pick& pick) {
  const std::optional<Eigen::Vector3d> at = placeOf(pick);
  if (!at)
    throw Error((registration_.wantsFixed() ? tr("click a point of the open scan (blue)")
                                            : tr("click a point of %1 (orange)").arg(name()))
                    .toStdString());
  const Eigen::Vector3d place =
      registration_.wantsFixed() ? *at : other_->cloud()->position(*pick.movedPoint);
  if (panel_->areSpheres())
    findSphere(place);
  else
    add(place);
}

void RegistrationFlow::findSphere(const Eigen::Vector3d& place) {
  const bool isFixed = registration_.wantsFixed();
  const Scan& scan = isFixed ? *parts_.document.scan() : *other_;
  sphere_.start(
      [cloud = scan.cloud(), index = freeIndex(scan), place,
       radius = panel_->sphereRadius()](const Progress& progress) {
        return targetSphere(*cloud, index, place, {.radius = radius, .reach = {}}, progress);
      },
      [this, isFixed](const TargetSphere& sphere) {
        if (!isActive() || registration_.wantsFixed() != isFixed) return;
        add(sphere.center);
        emit noted(tr("Sphere of radius %1, its points %2 off")
                       .arg(formatLength(sphere.radius, parts_.document.unit(), 3),
                            formatLength(sphere.residual, parts_.document.unit(), 2)));
      });
}

void RegistrationFlow::add(const Eigen::Vector3d& place) {
  change([&] {
    if (registration_.wantsFixed())
      registration_.addFixed(place);
    else
      registration_.addMoved(place);
  });
}

void RegistrationFlow::change(const std::function<void()>& act) {
  sphere_.cancel(); // of a click before
  const Eigen::Isometry3d before = registration_.motion();
  act();
  parts_.view.showPreview({});
  if (!registration_.motion().isApprox(before, 0)) colorByDistance();
  show();
  emit outdated();
}

void RegistrationFlow::leave() {
  if (mayLose()) end();
}

bool RegistrationFlow::mayLose() {
  if (!isActive() || !registration_.hasWork()) return true;
  QMessageBox box(QMessageBox::NoIcon, tr("Registration"),
                  tr("<b>Leave the registration of %1?</b>").arg(name()), QMessageBox::NoButton,
                  &parts_.window.window);
  box.setInformativeText(tr("The targets that were picked, and where it was moved to, are lost."));
  QPushButton* leaves = box.addButton(tr("Leave"), QMessageBox::DestructiveRole);
  QPushButton* goesOn = box.addButton(tr("Go On"), QMessageBox::RejectRole);
  box.setDefaultButton(goesOn);
  box.setEscapeButton(goesOn);
  box.exec();
  return box.clickedButton() == leaves;
}

void RegistrationFlow::end() {
  if (!isActive()) return;
  sphere_.cancel();
  distances_.cancel();
  values_.reset();
  other_.reset();
  registration_ = {};
  press_.reset();
  parts_.editing.borrow({});
  parts_.view.showPreview({});
  parts_.window.actions["color_scan_distance"]->setChecked(false);
  show();
  emit ended();
}

void RegistrationFlow::show() {
  const LengthUnit unit = parts_.document.unit();
  panel_->setUnit(symbol(unit));
  refreshActions();
  emit hintChanged();
  emit changed();
  if (!isActive()) {
    parts_.view.setMovedScan(std::nullopt);
    panel_->show(std::nullopt);
    return;
  }
  ShownScan scan{.cloud = other_->cloud(),
                 .motion = registration_.motion(),
                 .foreground = foreground(),
                 .values = values_};
  const std::vector<double> residuals = registration_.residuals();
  const std::optional<std::size_t> worst = registration_.worst();
  RegistrationPanel::Shown words{.next = nextText(), .pairs = {}, .warning = warning()};
  for (std::size_t i = 0; i < registration_.pairs().size(); ++i) {
    const TargetPair& pair = registration_.pairs()[i];
    scan.targets.push_back({static_cast<int>(i) + 1, pair.fixed, pair.moved, worst == i});
    words.pairs.push_back(
        {residuals.empty() ? QString() : formatLength(residuals[i], unit, 3), worst == i});
  }
  if (registration_.pending())
    scan.targets.push_back(
        {static_cast<int>(registration_.pairs().size()) + 1, registration_.pending(), {}, false});
  if (!residuals.empty())
    words.byPairs =
        tr("Of all pairs: %1 root mean square").arg(formatLength(registration_.rms(), unit, 3));
  if (const auto& fit = registration_.byPoints())
    words.byPoints = tr("By points: %1 root mean square across the surfaces, %2 % overlap")
                         .arg(formatLength(fit->rms, unit, 3))
                         .arg(std::lround(100 * fit->overlap));
  parts_.view.setMovedScan(scan);
  panel_->show(words);
}

Foreground RegistrationFlow::foreground() const {
  if (!registration_.wantsFixed() || values_) return Foreground::moved;
  return registration_.isPlaced() ? Foreground::both : Foreground::fixed;
}

QString RegistrationFlow::name() const {
  return QFileInfo(path_).fileName();
}

QString RegistrationFlow::nextText() const {
  if (!registration_.wantsFixed()) return tr("Click the same target in %1 (orange)").arg(name());
  return registration_.isPlaced()
             ? tr("Click another target in the open scan (blue), or fit by points, or join")
             : tr("Click a target in the open scan (blue)");
}

QString RegistrationFlow::warning() const {
  if (!registration_.refusal().empty()) return QString::fromStdString(registration_.refusal());
  const auto& fit = registration_.byPoints();
  const auto byPairs = registration_.rmsByPairs();
  if (fit && byPairs &&
      tookTargetsApart(registration_.rms(), *byPairs, parts_.document.scan()->spacing()))
    return withKeys(tr("By points, the targets are %1 apart; by pairs alone they were %2. Look "
                       "which lies better: {undo} takes the fit back.")
                        .arg(formatLength(registration_.rms(), parts_.document.unit(), 3),
                             formatLength(*byPairs, parts_.document.unit(), 3)),
                    parts_.window.actions);
  constexpr double far = 0.02; // of the plant: clicks are nearer than that
  if (registration_.rms() > far * parts_.document.scan()->bounds().sizes().maxCoeff())
    return tr("The pairs do not fit together: one of them is not the same target in both.");
  if (fit && !fit->converged)
    return tr("It still moved when it was stopped: pick more targets, and fit again.");
  constexpr double little = 0.2;
  if (fit && fit->overlap < little)
    return tr("Little overlaps: look whether it lies well, or pick more targets.");
  return {};
}

} // namespace espalier
