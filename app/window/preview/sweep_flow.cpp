#include "app/window/preview/sweep_flow.h"

#include "app/window/evaluate/evaluation_flow.h"
#include "app/window/evaluate/reference_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/preview/judge_numbers.h"
#include "app/window/preview/options_text.h"
#include "app/window/preview/reconstruct_flow.h"
#include "app/window/preview/sweep_scores.h"
#include "core/pipeline/sweep.h"
#include "ui/document/number_box.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_text.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/number_field.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/step_form.h"
#include "ui/panels/sweep_strip.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// What stands on the card of a value.
QString labelOf(const Option& option, double value, const QString& unit) {
  return option.kind == OptionKind::choice
             ? shownText(option.choices[static_cast<std::size_t>(value)].label)
             : valueText(option, value, unit);
}

QString nameOf(const Step& step, const Option& option) {
  return SweepFlow::tr("%1: %2", "step, option")
      .arg(shownText(step.label), shownText(option.label));
}

/// How many numbers cards can have.
std::size_t scoresOfCard(bool hasReference) {
  const std::vector<JudgedNumber> all = judgedNumbers({}, hasReference);
  return static_cast<std::size_t>(std::ranges::count_if(
      all, [](const JudgedNumber& number) { return !number.shortName.isEmpty(); }));
}

/// What one would sweep of a step, or of the contraction: the first length.
QString usualOption(const QString& stepName, const PipelineOptions& options) {
  const Step& step = stepName.isEmpty() ? contractionStep() : stepNamed(stepName.toStdString());
  const std::vector<Option>& all = chosenMethod(step, options).options;
  const auto usual = std::ranges::find(all, OptionKind::length, &Option::kind);
  return usual == all.end() ? QString() : QString::fromStdString(step.name + "." + usual->name);
}

} // namespace

SweepFlow::SweepFlow(const Parts& parts) : parts_(parts) {
  dock_ = addDock(
      new PanelDock(parts_.window,
                    {.id = "sweep",
                     .title = tr("Sweep"),
                     .text = tr("Sweep of a Parameter"),
                     .help = tr("Shows or hides what comes of several values of one option"),
                     .keys = QKeySequence(Qt::SHIFT | Qt::Key_F7),
                     .manual = "preview.md#the-sweep"},
                    makePanel(), this));
  connect(&job_, &JobSlot::failed, this, [this](const QString& message) {
    if (next_ >= trials_.size()) return;
    trials_[next_].item.failure = message;
    trials_[next_].item.isPending = false;
    ++next_;
    showCards();
    runNext();
  });
  connect(&parts_.document, &PlantDocument::scanChanged, this, [this] {
    stop();
    trials_.clear();
    showCards();
    listOptions();
    proposeRange();
  });
  const auto follow = [this] {
    listOptions();
    showCards(); // which of them is in use
  };
  connect(&parts_.pipeline, &PipelinePanel::changed, this, follow);
  connect(&parts_.pipeline, &PipelinePanel::replaced, this, follow);
  connect(&parts_.document, &PlantDocument::unitChanged, this, &SweepFlow::proposeRange);
  seen_.setSingleShot(true);
  connect(&seen_, &QTimer::timeout, this, &SweepFlow::pictureNext);
  const auto pictureAnew = [this] {
    pictured_ = 0;
    if (parts_.window.actions["show_sweep"]->isChecked()) seen_.start(300);
  };
  connect(&parts_.view, &PlantView::cameraMoved, this, pictureAnew);
  connect(strip_, &SweepStrip::resized, this, pictureAnew);
  listOptions();
}

SweepFlow::~SweepFlow() = default;

QWidget* SweepFlow::makePanel() {
  auto* panel = new QWidget;
  panel->setObjectName("sweep_panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  option_ = new QComboBox;
  opensOnEnter(*option_);
  option_->setObjectName("sweep_option");
  option_->setAccessibleName(tr("Option that is swept"));
  row->addWidget(option_);
  count_ = new QSpinBox;
  count_->setObjectName("sweep_count");
  count_->setAccessibleName(tr("How many values"));
  count_->setRange(2, 12);
  count_->setValue(5);
  count_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  count_->setSuffix(tr(" values"));
  count_->setToolTip(tr("%1 to %2 values").arg(count_->minimum()).arg(count_->maximum()));
  row->addWidget(count_);
  const auto addEnd = [&](const QString& name, const QString& label, const QString& help) {
    auto* number = new NumberBox;
    number->setObjectName(name);
    number->setAccessibleName(help);
    number->setToolTip(help);
    number->setButtonSymbols(QAbstractSpinBox::NoButtons);
    number->setFixedWidth(88);
    row->addWidget(new QLabel(label));
    row->addWidget(number);
    return number;
  };
  from_ = addEnd("sweep_from", tr("from"), tr("The least value"));
  to_ = addEnd("sweep_to", tr("to"), tr("The greatest value"));
  run_ = new QPushButton(tr("Run"));
  run_->setObjectName("sweep_run");
  run_->setToolTip(tr("Reconstructs the plant with each value; nothing of it changes"));
  row->addWidget(run_);
  note_ = new QLabel;
  note_->setObjectName("sweep_note");
  note_->setProperty("role", "quiet");
  row->addWidget(note_, 1);
  column->addLayout(row);
  strip_ = new SweepStrip;
  strip_->setObjectName("sweep_strip");
  column->addWidget(strip_, 1);
  connect(run_, &QPushButton::clicked, this, [this] {
    if (job_.isBusy())
      stop();
    else
      start();
  });
  connect(option_, &QComboBox::currentIndexChanged, this, &SweepFlow::proposeRange);
  connect(&job_, &JobSlot::finished, this, [this] { run_->setText(tr("Run")); });
  connect(strip_, &SweepStrip::chosen, this, &SweepFlow::take);
  return panel;
}

void SweepFlow::listOptions() {
  const QVariant before = option_->currentData();
  const QSignalBlocker quiet(option_);
  option_->clear();
  const PipelineOptions options = parts_.pipeline.options();
  for (const Step& step : pipelineSteps()) {
    const auto add = [&](const Option& option) {
      option_->addItem(nameOf(step, option), QString::fromStdString(step.name + "." + option.name));
    };
    if (step.methods.size() > 1) add(methodOption(step));
    std::ranges::for_each(chosenMethod(step, options).options, add);
  }
  int shown = before.isValid() ? option_->findData(before) : -1;
  if (shown < 0)
    shown = option_->findData(usualOption(before.toString().section('.', 0, 0), options));
  option_->setCurrentIndex(std::max(shown, 0));
  run_->setEnabled(parts_.document.scan() != nullptr);
  if (!before.isValid() || option_->currentData() != before) proposeRange();
}

void SweepFlow::proposeRange() {
  const Scan* scan = parts_.document.scan();
  const QStringList names = option_->currentData().toString().split('.');
  if (scan == nullptr || names.size() != 2) return;
  const Option& option =
      optionOfChosen(parts_.pipeline.options(), names[0].toStdString(), names[1].toStdString());
  for (QWidget* field : std::initializer_list<QWidget*>{count_, from_, to_})
    field->setEnabled(!option.takesWords()); // all of its words are tried
  if (option.takesWords()) return;
  const std::vector<double> ends = sweepValues(option, parts_.document.scale(), 2);
  for (QDoubleSpinBox* number : {from_, to_})
    dress(*number, option, parts_.document.scale(), symbol(parts_.document.unit()));
  from_->setValue(ends.front());
  to_->setValue(ends.back());
  proposed_ = {from_->value(), to_->value()};
}

void SweepFlow::start() {
  const Scan* scan = parts_.document.scan();
  const QStringList names = option_->currentData().toString().split('.');
  if (scan == nullptr || names.size() != 2) return;
  const std::string step = names[0].toStdString();
  const PipelineOptions options = parts_.pipeline.options();
  const Option& option = optionOfChosen(options, step, names[1].toStdString());
  trials_.clear();
  sweptOption_ = &option;
  sweptStep_ = step;
  std::optional<std::pair<double, double>> range = std::minmax(from_->value(), to_->value());
  if (range == proposed_) range.reset(); // the default, which is among them, is not rounded
  for (const double value : sweepValues(option, parts_.document.scale(), count_->value(), range)) {
    trials_.push_back({.options = withValue(options, stepNamed(step), option, value)});
    const QString label = labelOf(option, value, symbol(parts_.document.unit()));
    // Methods begin with their own defaults, but the one that is chosen stays as it is set.
    const bool isAsSet =
        &option == &methodOption(stepNamed(step)) && trials_.back().options.settings.contains(step);
    trials_.back().item = {.of = option_->currentText(),
                           .label = isAsSet ? tr("%1, as set").arg(label) : label,
                           .isPending = true};
  }
  next_ = 0;
  planned_ = trials_.size();
  swept_ = option_->currentText();
  run_->setText(tr("Stop"));
  strip_->setLeastRows(scoresOfCard(parts_.reference.skeleton() != nullptr));
  showCards();
  QTimer::singleShot(0, dock_, [this] { // once the strip knows its place
    dock_->growBy(strip_->heightForScores() - strip_->height());
  });
  runNext();
}

void SweepFlow::stop() {
  job_.cancel();
  std::erase_if(trials_, [](const Trial& trial) { return trial.item.isPending; });
  showCards();
}

void SweepFlow::runNext() {
  if (next_ >= trials_.size()) return;
  const Scan& scan = *parts_.document.scan();
  PipelineOptions options = trials_[next_].options;
  options.leftOut = parts_.document.leftOut();
  job_.start(
      [pipeline = parts_.reconstruct.pipeline(), cloud = scan.cloud(), spacing = scan.spacing(),
       reference = parts_.reference.skeleton(), comparing = parts_.evaluation.options(),
       options](const Progress& progress) {
        const Reconstruction made = pipeline->run(cloud, options, progress.part(0, 0.8));
        const Outcome outcome{.options = options,
                              .contracted = made.contracted,
                              .scanned = nullptr,
                              .skeleton = made.skeleton,
                              .within = std::nullopt,
                              .quality = nullptr};
        return std::pair(outcome, judged(outcome, *cloud, spacing, reference.get(), comparing,
                                         progress.part(0.8, 1)));
      },
      [this](const std::pair<Outcome, Judgment>& result) { finish(result.first, result.second); });
}

void SweepFlow::finish(const Outcome& outcome, const Judgment& judgment) {
  Trial& trial = trials_[next_];
  trial.judgment = judgment;
  trial.outcome = outcome;
  picture(trial);
  trial.item.isPending = false;
  ++next_;
  showCards();
  runNext();
}

/// Of what is in the middle of the view: where one looks, values differ most.
void SweepFlow::picture(Trial& trial) const {
  PlantState state = trial.outcome->shownAs({});
  state.replacesPoints = true;
  const QSize size = strip_->pictureSize().expandedTo({16, 16});
  trial.item.picture = parts_.view.pictureOf(state, 2 * size, PlantView::Framing::asSeen);
  trial.item.picture.setDevicePixelRatio(2);
}

void SweepFlow::pictureNext() {
  while (pictured_ < trials_.size() && !trials_[pictured_].outcome)
    ++pictured_;
  if (pictured_ >= trials_.size()) return;
  picture(trials_[pictured_]);
  strip_->setItem(pictured_, trials_[pictured_].item);
  ++pictured_;
  seen_.start(0);
}

PipelineOptions SweepFlow::inUse() const {
  PipelineOptions options = parts_.pipeline.options();
  const Scan* scan = parts_.document.scan();
  if (scan == nullptr || sweptOption_ == nullptr) return options;
  const Step& step = stepNamed(sweptStep_);
  if (sweptOption_ == &methodOption(step)) {
    options.methods[sweptStep_] = chosenMethod(step, options).name;
    return options;
  }
  Rule& rule = options.settings[sweptStep_]
                   .try_emplace(sweptOption_->name, sweptOption_->rule)
                   .first->second;
  rule = fixedAt(rule.value(parts_.document.scale()));
  return options;
}

void SweepFlow::showCards() {
  const PipelineOptions now = inUse();
  std::vector<Judgment> judgments;
  for (const Trial& trial : trials_)
    judgments.push_back(trial.judgment);
  const std::vector<std::vector<SweepScore>> scores =
      sweepScores(judgments, sweptOption_ == nullptr || !sweptOption_->takesWords());
  for (std::size_t i = 0; i < trials_.size(); ++i) {
    trials_[i].item.scores = scores[i];
    trials_[i].item.isCurrent = trials_[i].options == now;
  }
  std::vector<SweepItem> items;
  for (const Trial& trial : trials_)
    items.push_back(trial.item);
  strip_->setItems(items);
  note_->setText(noteOnCards());
}

QString SweepFlow::noteOnCards() const {
  if (trials_.empty()) return tr("Tries values of one option; a click takes one");
  const bool isStopped = trials_.size() < planned_;
  return (isStopped ? tr("%1: stopped, %2 of %3 done") : tr("%1: %2 of %3 done"))
      .arg(swept_)
      .arg(std::min(next_, trials_.size()))
      .arg(planned_);
}

ChoiceRecord SweepFlow::record() const {
  const std::vector<JudgedNumber> numbers =
      judgedNumbers(symbol(parts_.document.unit()), parts_.reference.skeleton() != nullptr);
  ChoiceRecord record{.title = tr("Sweep of %1").arg(swept_),
                      .time = {},
                      .seen = paperKey(true) + ' ' + tr("The middle of the view."),
                      .meanings = meaningsOf(numbers),
                      .states = {}};
  for (const Trial& trial : trials_)
    if (trial.outcome)
      record.states.push_back(
          {.name = trial.item.label,
           .options = {},
           .picture = parts_.view.paperOf(trial.outcome->shownAs({}), recordedPicture,
                                          PlantView::Framing::asSeen),
           .numbers = recorded(numbers, trial.judgment),
           .isTaken = trial.item.isCurrent});
  return record;
}

void SweepFlow::take(std::size_t index) {
  parts_.document.setUp(trials_[index].options.up); // it was made so
  parts_.document.setRoot(trials_[index].options.root);
  parts_.pipeline.setOptions(trials_[index].options);
  showCards();
  emit taken();
  emit keptChanged();
  emit noted(withKeys(tr("Set: %1 %2   {reconstruct} make the plant with it")
                          .arg(swept_, trials_[index].item.label),
                      parts_.window.actions));
}

} // namespace espalier
