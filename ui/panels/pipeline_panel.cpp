#include "ui/panels/pipeline_panel.h"

#include "ui/document/plant_document.h"
#include "ui/panels/measures_form.h"
#include "ui/panels/scan_form.h"
#include "ui/panels/step_form.h"
#include "ui/panels/wide_enough.h"

#include <QCheckBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {
PipelinePanel::PipelinePanel(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), scroll_(new QScrollArea(this)),
      live_(new QCheckBox(tr("Live preview"), this)),
      run_(new QPushButton(tr("Reconstruct"), this)) {
  run_->setProperty("role", "primary");
  run_->setObjectName("reconstruct_button");
  run_->setToolTip(tr("Makes the skeleton from the scan"));
  auto* page = new QWidget;
  page->setObjectName("pipeline_page");
  auto* list = new QVBoxLayout(page);
  list->setContentsMargins(0, 0, 0, 8);
  list->setSpacing(0);
  int number = 0;
  measures_ = new MeasuresForm(page);
  list->addWidget(measures_);
  list->addWidget(makeFold(page));
  for (const Step& step : pipelineSteps()) {
    steps_.push_back(new StepForm(step, step.isOptional ? 0 : ++number, page));
    steps_.back()->setOpen(&step == &contractionStep());
    list->addWidget(steps_.back());
    connect(steps_.back(), &StepForm::changed, this, [this, form = steps_.back()] {
      markStale(form);
      emit changed(form->step());
    });
    connect(steps_.back(), &StepForm::opened, this, [this, form = steps_.back()] {
      QTimer::singleShot(0, form, [this, form] { scrollTo(*form); }); // once it has its height
    });
    connect(steps_.back(), &StepForm::runRequested, this,
            [this, form = steps_.back()] { emit runRequested(form->step()); });
  }
  list->addStretch(1);
  scroll_->setWidget(page);
  scroll_->setAccessibleName(tr("Steps"));
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  keepWideEnough(*scroll_);
  auto* scan = new ScanForm(document, this);
  scan->setContentsMargins(12, 12, 12, 12);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(12, 8, 12, 12);
  foot->setSpacing(8);
  foot->addWidget(live_);
  foot->addWidget(run_);
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
  connect(scan, &ScanForm::rootAsked, this, &PipelinePanel::rootAsked);
  column_->addWidget(scan);
  column_->addWidget(scroll_, 1);
  column_->addLayout(foot);
  connect(run_, &QPushButton::clicked, this, &PipelinePanel::reconstructRequested);
  live_->setObjectName("live_preview");
  live_->setToolTip(tr("Shows what each change of a step would make, at once"));
  connect(live_, &QCheckBox::toggled, this, &PipelinePanel::liveToggled);
  connect(&document_, &PlantDocument::scanChanged, this, &PipelinePanel::refreshScale);
  connect(&document_, &PlantDocument::unitChanged, this, &PipelinePanel::refreshScale);
  connect(&document_, &PlantDocument::leftOutChanged, this, &PipelinePanel::showScale);
  connect(&document_, &PlantDocument::rootChanged, this, &PipelinePanel::takeRoot);
  connect(&document_, &PlantDocument::upChanged, this, &PipelinePanel::takeUp);
  connect(&document_, &PlantDocument::skeletonReplaced, this, &PipelinePanel::showIdle);
  refreshScale();
  showOptional();
}

void PipelinePanel::addBelowScan(QWidget* widget) {
  column_->insertWidget(column_->indexOf(scroll_), widget);
}

/// Steps that few plants need: one line, until they are asked for or on.
QWidget* PipelinePanel::makeFold(QWidget* page) {
  fold_ = new QToolButton(page);
  fold_->setObjectName("more_cleaning");
  fold_->setProperty("role", "step");
  fold_->setText(tr("More steps"));
  fold_->setToolTip(tr("Steps for scans that hold more than one plant: crop, ground, poles, wires, "
                       "other plants, fewer points; and one that smooths thick wood"));
  fold_->setCheckable(true);
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(fold_, &QToolButton::toggled, this, &PipelinePanel::showOptional);
  return fold_;
}

/// Those that are on are shown always.
void PipelinePanel::showOptional() {
  fold_->setArrowType(fold_->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  const PipelineOptions now = options();
  for (StepForm* form : steps_)
    if (form->step().isOptional) form->setVisible(fold_->isChecked() || !isOff(form->step(), now));
}

PipelineOptions PipelinePanel::options() const {
  PipelineOptions options{
      .root = document_.root(), .up = document_.up(), .organs = document_.organs()};
  for (const StepForm* step : steps_)
    step->addTo(options);
  return options;
}

void PipelinePanel::setOptions(const PipelineOptions& options) {
  const PipelineOptions before = this->options();
  for (StepForm* step : steps_)
    step->choose(options);
  showOptional();
  markStaleSince(before);
  emit replaced();
}

void PipelinePanel::showRunning(const QString& stage) {
  const auto isStage = [&](const StepForm* step) {
    return QString::fromStdString(step->step().label) == stage;
  };
  if (std::ranges::none_of(steps_, isStage)) return; // of no step: all is done, or nothing yet
  bool isBefore = true;
  for (StepForm* step : steps_) {
    const bool isNow = isStage(step);
    if (isNow) isBefore = false;
    step->setState(isNow      ? StepForm::State::running
                   : isBefore ? StepForm::State::done
                              : StepForm::State::idle);
  }
}

void PipelinePanel::showDone(const StepTexts& texts, const std::string& last) {
  bool isBehind = false;
  for (StepForm* form : steps_) {
    const StepText text = texts && !isBehind ? texts(form->step()) : StepText();
    if (!isBehind)
      form->setState(StepForm::State::done, text.note, text.details);
    else if (form->state() != StepForm::State::idle)
      form->setState(StepForm::State::stale);
    isBehind = isBehind || form->step().name == last;
  }
}

void PipelinePanel::showMadeWith(const PipelineOptions& made, const StepTexts& texts,
                                 const std::string& last) {
  showDone(texts, last);
  const PipelineOptions now = options();
  if (now.up != made.up) markStale(steps_.front());
  if (now.root != made.root) markStale(firstFromRoot());
  markStaleSince(made);
}

/// From the first step on that is set otherwise than it was.
void PipelinePanel::markStaleSince(const PipelineOptions& before) {
  const PipelineOptions now = options();
  const auto changed = std::ranges::find_if(
      steps_, [&](const StepForm* form) { return !isSameIn(form->step(), now, before); });
  if (changed != steps_.end()) markStale(*changed);
}

/// Most methods that clean look for no root; what comes behind them may.
const StepForm* PipelinePanel::firstFromRoot() const {
  const PipelineOptions now = options();
  return *std::ranges::find_if(steps_, [&](const StepForm* form) {
    const Step& step = form->step();
    return step.makes > StepResult::cleaned ||
           (!isOff(step, now) && chosenMethod(step, now).seesRoot);
  });
}

void PipelinePanel::takeRoot() {
  markStale(firstFromRoot());
  if (document_.scan() != nullptr) emit changed(firstFromRoot()->step());
}

/// What follows from the height of the plant is another, too.
void PipelinePanel::takeUp() {
  if (document_.scan() == nullptr) return;
  showScale();
  markStale(steps_.front());
  emit changed(steps_.front()->step());
}

void PipelinePanel::showFailed(const QString& why) {
  bool isBehind = false;
  for (StepForm* form : steps_) {
    if (form->state() == StepForm::State::running) {
      form->setState(StepForm::State::failed, {}, why);
      isBehind = true;
    } else if (isBehind) {
      form->setState(StepForm::State::idle);
    }
  }
}

void PipelinePanel::showStopped() {
  for (StepForm* form : steps_)
    if (form->state() == StepForm::State::running) return markStale(form);
}

void PipelinePanel::markStale(const StepForm* from) {
  bool isBehind = false;
  for (StepForm* form : steps_) {
    isBehind = isBehind || form == from;
    if (isBehind && form->state() != StepForm::State::idle) form->setState(StepForm::State::stale);
  }
}

bool PipelinePanel::isLive() const {
  return live_->isChecked();
}

void PipelinePanel::setLive(bool isLive) {
  live_->setChecked(isLive);
}

void PipelinePanel::showIdle() {
  for (StepForm* step : steps_)
    step->setState(StepForm::State::idle);
}

void PipelinePanel::setRunnable(bool isRunnable) {
  run_->setEnabled(isRunnable);
  for (StepForm* step : steps_)
    step->setRunnable(isRunnable);
}

void PipelinePanel::setDensities(const std::string& step, const std::vector<float>& densities) {
  for (StepForm* form : steps_)
    if (form->step().name == step) form->setDensities(densities);
}

/// Shows all of a form, or its beginning if it is higher than the list.
void PipelinePanel::scrollTo(const StepForm& form) {
  const int bottom = form.geometry().bottom() + 1 - scroll_->viewport()->height();
  QScrollBar& bar = *scroll_->verticalScrollBar();
  bar.setValue(std::min(std::max(bar.value(), bottom), form.geometry().top()));
}

void PipelinePanel::refreshScale() {
  showScale();
  setRunnable(document_.scan() != nullptr);
  showIdle();
}

/// Without a scan, nothing shows what the options of a plant may be.
void PipelinePanel::showScale() {
  if (document_.scan() == nullptr) return;
  for (StepForm* step : steps_)
    step->setScale(document_.scale(), symbol(document_.unit()));
}

} // namespace espalier
