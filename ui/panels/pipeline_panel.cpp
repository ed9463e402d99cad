#include "ui/panels/pipeline_panel.h"

#include "ui/document/plant_document.h"
#include "ui/panels/scan_form.h"
#include "ui/panels/step_form.h"

#include <QEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace espalier {
namespace {

/// Keeps a scroll area as wide as what is in it needs: nothing is cut off at its right.
class WideEnough : public QObject {
public:
  explicit WideEnough(QScrollArea& area) : QObject(&area), area_(area) {}

  bool eventFilter(QObject* page, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest)
      area_.setMinimumWidth(area_.widget()->minimumSizeHint().width() +
                            area_.verticalScrollBar()->sizeHint().width());
    return QObject::eventFilter(page, event);
  }

private:
  QScrollArea& area_;
};

} // namespace

PipelinePanel::PipelinePanel(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), run_(new QPushButton(tr("Reconstruct"), this)) {
  run_->setProperty("role", "primary");
  run_->setObjectName("reconstruct_button");
  run_->setToolTip(tr("Makes the skeleton from the scan"));
  auto* page = new QWidget;
  page->setObjectName("pipeline_page");
  auto* list = new QVBoxLayout(page);
  list->setContentsMargins(0, 0, 0, 8);
  list->setSpacing(0);
  int number = 0;
  for (const Step& step : pipelineSteps()) {
    steps_.push_back(new StepForm(step, ++number, page));
    steps_.back()->setOpen(step.name == "contract");
    list->addWidget(steps_.back());
    connect(steps_.back(), &StepForm::changed, this, &PipelinePanel::showIdle);
    connect(steps_.back(), &StepForm::changed, this, &PipelinePanel::changed);
  }
  list->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(page);
  scroll->setAccessibleName(tr("Steps"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  page->installEventFilter(new WideEnough(*scroll));
  auto* scan = new ScanForm(document, this);
  scan->setContentsMargins(12, 12, 12, 12);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(12, 8, 12, 12);
  foot->addWidget(run_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(scan);
  column->addWidget(scroll, 1);
  column->addLayout(foot);
  connect(run_, &QPushButton::clicked, this, &PipelinePanel::reconstructRequested);
  connect(&document_, &PlantDocument::scanChanged, this, &PipelinePanel::refreshScale);
  connect(&document_, &PlantDocument::unitChanged, this, &PipelinePanel::refreshScale);
  connect(&document_, &PlantDocument::skeletonReplaced, this, &PipelinePanel::showIdle);
  refreshScale();
}

PipelineOptions PipelinePanel::options() const {
  PipelineOptions options;
  for (const StepForm* step : steps_)
    step->addTo(options);
  return options;
}

void PipelinePanel::setOptions(const PipelineOptions& options) {
  for (StepForm* step : steps_)
    step->choose(options);
  showIdle();
}

void PipelinePanel::showRunning(const QString& stage) {
  bool isBefore = true;
  for (StepForm* step : steps_) {
    const bool isNow = QString::fromStdString(step->step().label) == stage;
    if (isNow) isBefore = false;
    step->setState(isNow      ? StepForm::State::running
                   : isBefore ? StepForm::State::done
                              : StepForm::State::idle);
  }
}

void PipelinePanel::showDone() {
  for (StepForm* step : steps_)
    step->setState(StepForm::State::done);
}

void PipelinePanel::showIdle() {
  for (StepForm* step : steps_)
    step->setState(StepForm::State::idle);
}

void PipelinePanel::setRunnable(bool isRunnable) {
  run_->setEnabled(isRunnable);
}

void PipelinePanel::refreshScale() {
  const Scan* scan = document_.scan();
  if (scan != nullptr) // else nothing tells what the options of a plant may be
    for (StepForm* step : steps_)
      step->setScale({.spacing = scan->spacing(), .height = scan->height()},
                     symbol(document_.unit()));
  setRunnable(scan != nullptr);
  showIdle();
}

} // namespace espalier
