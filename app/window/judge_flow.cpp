#include "app/window/judge_flow.h"

#include "app/window/action_set.h"
#include "app/window/evaluation_flow.h"
#include "app/window/judge_numbers.h"
#include "app/window/options_text.h"
#include "app/window/reconstruct_flow.h"
#include "app/window/reference_flow.h"
#include "app/window/states_flow.h"
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

constexpr QSize recordedPicture(480, 480);

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
  dock_ = new PanelDock(parts_.window,
                        {.id = "judge",
                         .title = tr("Preview in Numbers"),
                         .text = tr("Preview in Numbers"),
                         .help = tr("Shows or hides the numbers by which a preview is judged"),
                         .keys = QKeySequence(Qt::SHIFT | Qt::Key_F6)},
                        makePanel(), this);
  timer_.setSingleShot(true);
  timer_.setInterval(300); // [ms]: edits in a row are judged once
  connect(&timer_, &QTimer::timeout, this, &JudgeFlow::judge);
  const auto later = [this] { timer_.start(); };
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
  kind_->addItems({tr("Residual thickness"), tr("Displacement"), tr("Density"),
                   tr("Quality of directions"), tr("Radius of nodes")});
  histogram_ = new HistogramView;
  histogram_->setObjectName("judge_histogram");
  note_ = new QLabel;
  note_->setProperty("role", "quiet");
  note_->setWordWrap(true);
  column->addWidget(kind_);
  column->addWidget(histogram_, 1);
  column->addWidget(note_);
  row->addLayout(column, 2);
  connect(kind_, &QComboBox::currentIndexChanged, this, &JudgeFlow::judge);
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
    states.push_back({.name = tr("Plant"), .outcome = parts_.states.plant()});
  if (parts_.states.kept()) states.push_back({.name = tr("A"), .outcome = *parts_.states.kept()});
  if (!parts_.preview.shown()) std::ranges::reverse(states); // the plant is what became of A
  if (parts_.preview.shown())
    states.push_back(
        {.name = parts_.preview.shown()->within ? tr("Preview, in the ball") : tr("Preview"),
         .outcome = *parts_.preview.shown()});
  return states;
}

void JudgeFlow::judge() {
  timer_.stop();
  const Scan* scan = parts_.document.scan();
  if (scan == nullptr || !parts_.window.actions["show_judge"]->isChecked()) {
    job_.cancel();
    shown_.clear();
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
  table_->show(names, shown_.empty() ? std::vector<JudgeRow>() : rows(), !isPart);
  showHistogram();
}

ChoiceRecord JudgeFlow::record() const {
  ChoiceRecord record;
  if (shown_.empty() || parts_.document.scan() == nullptr) return record;
  if (shown_.back().outcome.within || parts_.preview.isBusy() || isBusy())
    throw Error(tr("the preview is not of the whole scan yet: wait a moment").toStdString());
  const Scan& scan = *parts_.document.scan();
  const PlantScale scale{.spacing = scan.spacing(), .height = scan.height()};
  const std::vector<JudgeRow> numbers = rows();
  QStringList names;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const State& state = shown_[i];
    names.append(state.name);
    ChoiceState chosen{
        .name = state.name,
        .options = changeText({}, state.outcome.options, scale, symbol(parts_.document.unit())),
        .picture = parts_.view.pictureOf(state.outcome.shownAs({}), recordedPicture,
                                         PlantView::Framing::whole),
        .numbers = {},
        .isTaken = i + 1 == shown_.size()};
    for (const JudgeRow& row : numbers)
      if (row.values[i])
        chosen.numbers.emplace_back(row.unit.isEmpty() ? row.name
                                                       : tr("%1 [%2]").arg(row.name, row.unit),
                                    numberText(*row.values[i], row.decimals));
    record.states.push_back(std::move(chosen));
  }
  record.title = names.join(tr(" and "));
  return record;
}

void JudgeFlow::showHistogram() {
  const QString unit = symbol(parts_.document.unit());
  const QString units[] = {tr("spacings"), unit, {}, {}, unit};
  PlottedValues plotted{.values = {},
                        .title = kind_->currentText(),
                        .unit = units[kind_->currentIndex()],
                        .range = std::nullopt};
  const bool hasTwo = shown_.size() > 1;
  if (!shown_.empty()) plotted.values = shown_.back().values;
  if (hasTwo) plotted.range = rangeOfBoth(shown_.back().values, shown_.front().values);
  histogram_->show(plotted);
  histogram_->addSecond(hasTwo ? shown_.front().values : std::vector<float>(),
                        hasTwo ? shown_.front().name : QString());
  note_->setText(shown_.empty()
                     ? tr("Turn on Live Preview, or reconstruct, to judge what comes of it")
                 : hasTwo ? tr("Bars: %1. Outline: %2. Drag to select those points.")
                                .arg(shown_.back().name, shown_.front().name)
                          : tr("Drag to select those points"));
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
  parts_.preview.showScanned(); // where a selection is seen
  parts_.document.pointSelection().set(PointSet::of(points));
}

} // namespace espalier
