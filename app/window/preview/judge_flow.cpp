#include "app/window/preview/judge_flow.h"

#include "app/window/evaluate/evaluation_flow.h"
#include "app/window/evaluate/reference_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/preview/judge_numbers.h"
#include "app/window/preview/options_text.h"
#include "app/window/preview/reconstruct_flow.h"
#include "app/window/preview/states_flow.h"
#include "core/base/error.h"
#include "ui/document/binned_values.h"
#include "ui/document/number_scale.h"
#include "ui/document/plant_document.h"
#include "ui/panels/focus_keys.h"
#include "ui/plots/histogram_view.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// Where both can be seen; none: where the first can.
std::optional<std::pair<double, double>> rangeOfBoth(const std::vector<float>& first,
                                                     const std::vector<float>& second) {
  const BinnedValues one = binned(first);
  const BinnedValues other = binned(second);
  if (one.isEmpty() || other.isEmpty()) return std::nullopt;
  return std::pair(std::min(one.from, other.from), std::max(one.to, other.to));
}

} // namespace

JudgeFlow::JudgeFlow(const Parts& parts) : parts_(parts) {
  dock_ =
      addDock(new PanelDock(parts_.window,
                            {.id = "judge",
                             .title = tr("Preview in Numbers"),
                             .text = tr("Preview in Numbers"),
                             .help = tr("Shows or hides the numbers by which a preview is judged"),
                             .keys = QKeySequence(Qt::SHIFT | Qt::Key_F6),
                             .manual = "preview.md#judging-by-numbers"},
                            makePanel(), this));
  timer_.setSingleShot(true);
  timer_.setInterval(300); // [ms]: edits in a row are judged once
  connect(&timer_, &QTimer::timeout, this, &JudgeFlow::judge);
  connect(&job_, &JobSlot::finished, this, &JudgeFlow::showLegend);
  const auto later = [this] { judgeLater(); };
  connect(&parts_.preview, &PreviewFlow::changed, this, later);
  connect(&parts_.states, &StatesFlow::changed, this, later);
  connect(&parts_.reference, &ReferenceFlow::changed, this, later);
  connect(&parts_.evaluation, &EvaluationFlow::changed, this, later);
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::skeletonEdited, this, later);
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::contractedChanged, &PlantDocument::unitChanged})
    connect(&document, signal, this, later);
  connect(parts_.window.actions["show_judge"], &QAction::toggled, this, later);
}

JudgeFlow::~JudgeFlow() = default;

QWidget* JudgeFlow::makePanel() {
  auto* panel = new QWidget;
  panel->setObjectName("judge_panel");
  auto* row = new QHBoxLayout(panel);
  row->setContentsMargins(12, 8, 12, 8);
  row->setSpacing(16);
  table_ = new JudgeTable;
  table_->setObjectName("judge_table");
  row->addWidget(table_, 3);
  auto* column = new QVBoxLayout;
  column->setSpacing(4);
  kind_ = new QComboBox;
  opensOnEnter(*kind_);
  kind_->setObjectName("judge_kind");
  kind_->setAccessibleName(tr("What the histogram shows"));
  kind_->addItems({tr("Residual thickness"), tr("Distance from the axis"), tr("Displacement"),
                   tr("Relative density"), tr("Quality of directions"), tr("Radius of nodes")});
  histogram_ = new HistogramView;
  histogram_->setObjectName("judge_histogram");
  note_ = new QLabel;
  note_->setProperty("role", "quiet");
  note_->setWordWrap(true);
  column->addWidget(kind_);
  column->addWidget(histogram_, 1);
  column->addWidget(note_);
  row->addLayout(column, 2);
  connect(kind_, &QComboBox::currentIndexChanged, this, &JudgeFlow::chooseKind);
  connect(histogram_, &HistogramView::brushed, this,
          [this](double from, double to) { brush(from, to); });
  connect(histogram_, &HistogramView::brushCleared, this, [this] {
    parts_.document.pointSelection().clear();
    if (kind() == Distributed::radii) parts_.document.selection().set({});
  });
  return panel;
}

void JudgeFlow::setDark(bool isDark) {
  histogram_->setDark(isDark);
}

Distributed JudgeFlow::kind() const {
  return static_cast<Distributed>(kind_->currentIndex());
}

std::vector<JudgeFlow::State> JudgeFlow::states() const {
  std::vector<State> states;
  if (parts_.document.contracted() != nullptr || !parts_.document.skeleton().isEmpty())
    states.push_back({.name = tr("Plant"), .isPreview = false, .outcome = parts_.states.plant()});
  if (parts_.states.kept())
    states.push_back({.name = tr("A"), .isPreview = false, .outcome = *parts_.states.kept()});
  if (!parts_.preview.shown()) std::ranges::reverse(states); // the plant is what became of A
  if (parts_.preview.shown())
    states.push_back(
        {.name = parts_.preview.shown()->within ? tr("Preview, in the ball") : tr("Preview"),
         .isPreview = true,
         .outcome = *parts_.preview.shown()});
  return states;
}

/// A preview that is gone is taken away at once; what is new is shown once it is judged.
void JudgeFlow::judgeLater() {
  timer_.start();
  isCurrent_ = false;
  if (!parts_.preview.shown()) job_.cancel(); // it may still judge one
  if (!parts_.preview.shown() && !shown_.empty() && shown_.back().isPreview) {
    shown_.pop_back();
    std::ranges::reverse(shown_); // as states() has them
    return show();
  }
  showLegend();
}

/// Its name is there at once, its values once they are computed.
void JudgeFlow::chooseKind() {
  for (State& state : shown_)
    state.values.clear();
  areValuesComing_ = !shown_.empty();
  showHistogram();
  if (!isCurrent_) return judge();
  job_.start(
      [states = shown_, cloud = parts_.document.scan()->cloud(),
       spacing = parts_.document.scan()->spacing(), kind = kind()](const Progress& progress) {
        std::vector<std::vector<float>> values;
        values.reserve(states.size());
        for (const State& state : states)
          values.push_back(distribution(kind, state.outcome, *cloud, spacing, progress));
        return values;
      },
      [this](std::vector<std::vector<float>> values) {
        if (values.size() != shown_.size()) return; // they are others by now
        for (std::size_t i = 0; i < shown_.size(); ++i)
          shown_[i].values = std::move(values[i]);
        areValuesComing_ = false;
        showHistogram();
      });
}

void JudgeFlow::judge() {
  timer_.stop();
  const Scan* scan = parts_.document.scan();
  if (scan == nullptr || !parts_.window.actions["show_judge"]->isChecked()) {
    job_.cancel();
    shown_.clear();
    areValuesComing_ = false;
    return show();
  }
  job_.start(
      [states = states(), cloud = scan->cloud(), spacing = scan->spacing(),
       reference = parts_.reference.skeleton(), comparing = parts_.evaluation.options(),
       kind = kind()](const Progress& progress) mutable {
        for (State& state : states) {
          state.judgment =
              judged(state.outcome, *cloud, spacing, reference.get(), comparing, progress);
          state.outcome.quality = state.judgment.quality;
          state.values = distribution(kind, state.outcome, *cloud, spacing, progress);
        }
        return states;
      },
      [this](std::vector<State> judged) {
        shown_ = std::move(judged);
        isCurrent_ = !timer_.isActive();
        areValuesComing_ = false;
        show();
      });
}

std::vector<JudgeRow> JudgeFlow::rows() const {
  const std::vector<JudgedNumber> numbers =
      judgedNumbers(symbol(parts_.document.unit()), parts_.reference.skeleton() != nullptr);
  std::vector<JudgeRow> rows;
  for (const JudgedNumber& number : numbers) {
    JudgeRow row{.name = number.name,
                 .unit = number.unit,
                 .meaning = number.meaning,
                 .better = number.better,
                 .decimals = number.decimals,
                 .values = {}};
    for (const State& state : shown_)
      row.values.push_back(number.of(state.judgment));
    rows.push_back(std::move(row));
  }
  return rows;
}

void JudgeFlow::show() {
  QStringList names;
  for (const State& state : shown_)
    names.append(state.name);
  const bool isPart = !shown_.empty() && shown_.back().outcome.within;
  const bool wasEmpty = table_->rowCount() == 0;
  table_->show(names, shown_.empty() ? std::vector<JudgeRow>() : rows(), !isPart);
  if (wasEmpty && !shown_.empty()) QTimer::singleShot(0, dock_, [this] { showAllRows(); });
  showHistogram();
}

void JudgeFlow::showAllRows() {
  const QWidget& panel = *table_->parentWidget();
  const QMargins margins = panel.layout()->contentsMargins();
  const int needed = table_->heightForRows() + margins.top() + margins.bottom();
  dock_->growBy(needed - panel.parentWidget()->height());
}

ChoiceRecord JudgeFlow::record() const {
  ChoiceRecord record;
  if (shown_.empty() || parts_.document.scan() == nullptr) return record;
  if (shown_.back().outcome.within || parts_.preview.isBusy() || isBusy())
    throw Error(tr("the preview is not of the whole scan yet: wait a moment").toStdString());
  const PlantScale scale = parts_.document.scale();
  const QString unit = symbol(parts_.document.unit());
  const std::vector<JudgedNumber> numbers =
      judgedNumbers(unit, parts_.reference.skeleton() != nullptr);
  record.meanings = meaningsOf(numbers);
  QStringList names;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const State& state = shown_[i];
    names.append(state.name);
    const QString change = changeText({}, state.outcome.options, scale, unit);
    record.states.push_back(
        {.name = state.name,
         .options = change.isEmpty() ? tr("all as usual") : change,
         .picture = parts_.view.paperOf(state.outcome.shownAs({}), recordedPicture,
                                        PlantView::Framing::whole),
         .numbers = recorded(numbers, state.judgment),
         .isTaken = i + 1 == shown_.size()});
  }
  record.title = names.join(tr(" and "));
  record.seen = paperKey(shown_.back().outcome.contracted != nullptr);
  return record;
}

void JudgeFlow::showHistogram() {
  const QString unit = symbol(parts_.document.unit());
  const QString spacings = tr("spacings");
  const QString units[] = {
      spacings, spacings, unit, tr("0 thinnest, 1 densest"), tr("0 none, 1 a line"), unit};
  PlottedValues plotted{.values = {},
                        .title = kind_->currentText(),
                        .unit = units[kind_->currentIndex()],
                        .range = std::nullopt};
  const bool hasTwo = shown_.size() > 1;
  plotted.areComing = areValuesComing_;
  if (!shown_.empty()) plotted.values = shown_.back().values;
  if (hasTwo) plotted.range = rangeOfBoth(shown_.back().values, shown_.front().values);
  if (hasMedian())
    plotted.mark = {
        .value = shown_.back().judgment.quality->residualThickness,
        .text =
            tr("median %1").arg(numberText(shown_.back().judgment.quality->residualThickness, 2))};
  histogram_->show(plotted);
  histogram_->addSecond(hasTwo ? shown_.front().values : std::vector<float>(),
                        hasTwo ? shown_.front().name : QString());
  showLegend();
}

/// Does the histogram show what a number of the table is the median of?
bool JudgeFlow::hasMedian() const {
  return kind() == Distributed::thicknesses && !shown_.empty() && shown_.back().judgment.quality;
}

void JudgeFlow::showLegend() {
  if (shown_.empty())
    return note_->setText(tr("Turn on Live Preview, or reconstruct, to judge what comes of it"));
  QStringList parts;
  if (shown_.size() > 1)
    parts.append(tr("Bars: %1. Outline: %2.").arg(shown_.back().name, shown_.front().name));
  if (hasMedian()) parts.append(tr("Dashed: the number of the table."));
  parts.append(isBusy() ? tr("Computing…") : tr("Drag to select those points."));
  note_->setText(parts.join(' '));
}

void JudgeFlow::brush(double from, double to) {
  if (shown_.empty()) return;
  const State& state = shown_.back();
  const auto isIn = [&](float value) { return value >= from && value <= to; };
  if (kind() == Distributed::radii) {
    if (state.outcome.skeleton == nullptr || parts_.preview.shown()) return; // of another skeleton
    std::vector<NodeId> nodes;
    for (const NodeId id : parts_.document.skeleton().ids())
      if (isIn(static_cast<float>(parts_.document.skeleton()[id].radius))) nodes.push_back(id);
    return parts_.document.selection().set(nodes);
  }
  const std::vector<Eigen::Index>& columns = state.outcome.points;
  std::vector<Eigen::Index> points;
  for (std::size_t i = 0; i < state.values.size(); ++i)
    if (isIn(state.values[i]))
      points.push_back(columns.empty() ? static_cast<Eigen::Index>(i) : columns[i]);
  parts_.document.pointSelection().set(PointSet::of(points));
}

} // namespace espalier
