#include "app/window/action_set.h"
#include "app/window/choices_flow.h"
#include "app/window/density_flow.h"
#include "app/window/editing.h"
#include "app/window/evaluation_flow.h"
#include "app/window/findings_flow.h"
#include "app/window/history_flow.h"
#include "app/window/hull_flow.h"
#include "app/window/judge_flow.h"
#include "app/window/main_window.h"
#include "app/window/node_table_flow.h"
#include "app/window/point_states.h"
#include "app/window/points_flow.h"
#include "app/window/preset_flow.h"
#include "app/window/preview_flow.h"
#include "app/window/project_flow.h"
#include "app/window/radius_flow.h"
#include "app/window/recent_files.h"
#include "app/window/reconstruct_flow.h"
#include "app/window/reference_flow.h"
#include "app/window/review_flow.h"
#include "app/window/saved_views.h"
#include "app/window/seal_flow.h"
#include "app/window/shown_flow.h"
#include "app/window/sight_flow.h"
#include "app/window/stand_flow.h"
#include "app/window/states_flow.h"
#include "app/window/sweep_flow.h"
#include "app/window/theme_flow.h"
#include "app/window/unit_flow.h"
#include "app/window/value_colors.h"
#include "app/window/view_options.h"
#include "ui/dialogs/key_bindings.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/review_panel.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_line.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

namespace espalier {

void MainWindow::connectJobs() {
  connect(&jobs_, &JobRunner::started, this, [this] {
    preview_->stop();
    status_->showJob(jobs_.name());
    units_->setEnabled(false);
    radius_->setEnabled(false);
    seals_->setEnabled(false);
    review_->setEnabled(false);
    editing_->setEnabled(false); // what a job will replace is not to be edited meanwhile
    pipeline_->setRunnable(false);
    (*actions_)["reconstruct"]->setEnabled(false);
  });
  connect(&jobs_, &JobRunner::progressed, this, [this](double fraction, const QString& stage) {
    status_->showProgress(fraction, stage);
    if (reconstruct_->isRunning()) pipeline_->showRunning(stage);
  });
  connect(&jobs_, &JobRunner::failed, this, [this](const QString& message) {
    banner_->showError(message);
    if (reconstruct_->isRunning()) pipeline_->showFailed(message);
  });
  connect(&jobs_, &JobRunner::finished, this, [this] {
    status_->hideJob();
    preview_->goOn();
    editing_->setEnabled(true);
    units_->setEnabled(true);
    radius_->setEnabled(true);
    seals_->setEnabled(true);
    review_->setEnabled(true);
    if (jobs_.isCanceled()) {
      pipeline_->showStopped();
      status_->showNote(tr("Canceled: nothing has changed"));
    }
    refreshEmptiness();
  });
  connect(status_, &StatusLine::cancelRequested, &jobs_, &JobRunner::cancel);
  connect(reconstruct_.get(), &ReconstructFlow::done, this,
          [this](const QString& message, const std::string& last) {
            pipeline_->showDone(reconstruct_->telling(), last);
            projects_->noteChange();
            banner_->showResult(message, tr("Undo"), [this] { undoStep(); });
          });
}

void MainWindow::connectDocument() {
  for (auto signal : {&PlantDocument::titleChanged, &PlantDocument::scanChanged})
    connect(&document_, signal, this, &MainWindow::refreshTitle);
  for (auto signal :
       {&PlantDocument::scanChanged, &PlantDocument::skeletonReplaced, &PlantDocument::unitChanged})
    connect(&document_, signal, this, &MainWindow::refreshCounts);
  connect(&document_, &PlantDocument::skeletonEdited, this, &MainWindow::refreshCounts);
  connect(&document_, &PlantDocument::leftOutChanged, this, &MainWindow::refreshCounts);
  connect(points_.get(), &PointsFlow::changed, this,
          [this] { shown_->setPointsIsolated(pointStates_->isIsolated()); });
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::tellStep);
  connect(editing_.get(), &Editing::hintChanged, this, &MainWindow::refreshHint);
  connect(radius_.get(), &RadiusFlow::hintChanged, this, &MainWindow::refreshHint);
  connect(editing_.get(), &Editing::noted, status_, &StatusLine::showNote);
  connect(stand_.get(), &StandFlow::noted, status_, &StatusLine::showNote);
  connect(radius_.get(), &RadiusFlow::noted, status_, &StatusLine::showNote);
  connect(radius_.get(), &RadiusFlow::done, this, [this](const QString& message) {
    banner_->showResult(message, tr("Undo"), [this] { undoStep(); });
  });
  connect(units_.get(), &UnitFlow::marksChanged, this, [this] {
    refreshCounts();
    refreshHint();
  });
  connect(savedViews_.get(), &SavedViews::changed, projects_.get(), &ProjectFlow::noteChange);
  connect(view_, &PlantView::clipChanged, projects_.get(), &ProjectFlow::noteChange);
  connect(options_.get(), &ViewOptions::rangesChanged, projects_.get(), &ProjectFlow::noteChange);
  connect(shown_.get(), &ShownFlow::changed, this, &MainWindow::refreshCounts);
  connect(editing_.get(), &Editing::contextMenuRequested, this, &MainWindow::showContextMenu);
  connect(actions_.get(), &ActionSet::refused, this, &MainWindow::showRefusal);
  connect(actions_.get(), &ActionSet::acted, this, [this] { // why the last one was not is history
    if (banner_->isError() && banner_->text() == refusal_) banner_->hide();
  });
  connect(start_, &StartPage::openRequested, (*actions_)["open"], &QAction::trigger);
  connect(start_, &StartPage::fileChosen, this, [this](const QString& path) { open({path}); });
  connect(recent_.get(), &RecentFiles::changed, this,
          [this] { start_->setRecentFiles(recent_->paths()); });
  connect(pipeline_, &PipelinePanel::reconstructRequested, (*actions_)["reconstruct"],
          &QAction::trigger);
  connect(inspector_, &InspectorPanel::radiusTyped, this, [this](double radius) {
    actions_->guarded(
        [&] {
          setRadius(document_, document_.selection().nodes(), radius);
          return true;
        },
        Refusal::inBanner);
  });
  connect(inspector_, &InspectorPanel::leaveRequested, view_, qOverload<>(&QWidget::setFocus));
  connect(inspector_, &InspectorPanel::edgeChosen, this, [this](EdgeType type) {
    (*actions_)[type == EdgeType::successor ? "make_axial" : "make_branching"]->trigger();
  });
  connect(inspector_, &InspectorPanel::nodeChosen, this,
          [this](NodeId id) { document_.selection().set({id}); });
  start_->setRecentFiles(recent_->paths());
}

void MainWindow::connectReview() {
  const auto showSeal = [this] { review_->panel().showSeal(seals_->text()); };
  seals_->setSigner(review_->reviewer());
  connect(seals_.get(), &SealFlow::changed, this, showSeal);
  connect(seals_.get(), &SealFlow::signerChanged, review_.get(), &ReviewFlow::setReviewer);
  connect(review_.get(), &ReviewFlow::reviewerChanged, seals_.get(), &SealFlow::setSigner);
  connect(review_.get(), &ReviewFlow::noted, status_, &StatusLine::showNote);
  connect(editing_.get(), &Editing::hintChanged, this,
          [this] { review_->setInGesture(editing_->isPending()); });
  showSeal();
}

void MainWindow::connectFindings() {
  projects_->keep({.name = "ignored_findings",
                   .text = [this] { return findings_->text(); },
                   .show = [this](const std::string& text) { findings_->show(text); }});
  connect(findings_.get(), &FindingsFlow::ignoredChanged, projects_.get(),
          &ProjectFlow::noteChange);
  connect(findings_.get(), &FindingsFlow::noted, status_, &StatusLine::showNote);
  connect(hulls_.get(), &HullFlow::noted, status_, &StatusLine::showNote);
}

void MainWindow::connectAtHand() {
  connect(keys_, &KeyBindings::changed, this, &MainWindow::refreshHint);
  connect(theme_, &ThemeFlow::changed, view_, &PlantView::setDark);
  connect(history_.get(), &HistoryFlow::noted, status_, &StatusLine::showNote);
  connect(nodeTable_.get(), &NodeTableFlow::noted, status_, &StatusLine::showNote);
}

void MainWindow::connectEvaluation() {
  projects_->keep({.name = "reference",
                   .text = [this] { return reference_->text(); },
                   .show = [this](const std::string& text) { reference_->show(text); }});
  connect(reference_.get(), &ReferenceFlow::changed, projects_.get(), &ProjectFlow::noteChange);
  connect(reference_.get(), &ReferenceFlow::noted, status_, &StatusLine::showNote);
  connect(reference_.get(), &ReferenceFlow::loaded, banner_, &QWidget::hide); // of one refused
  connect(reference_.get(), &ReferenceFlow::openRequested, this, &MainWindow::open);
  projects_->keep({.name = "evaluation",
                   .text = [this] { return evaluation_->text(); },
                   .show = [this](const std::string& text) { evaluation_->show(text); }});
  connect(evaluation_.get(), &EvaluationFlow::changed, projects_.get(), &ProjectFlow::noteChange);
  MethodsFlow& methods = evaluation_->methods(); // behind what they are compared with, and how
  projects_->keep({.name = "methods",
                   .text = [&methods] { return methods.text(); },
                   .show = [&methods](const std::string& text) { methods.show(text); }});
  connect(&methods, &MethodsFlow::changed, projects_.get(), &ProjectFlow::noteChange);
  connect(evaluation_.get(), &EvaluationFlow::noted, status_, &StatusLine::showNote);
  connect(evaluation_.get(), &EvaluationFlow::reportWritten, this, [this](const QString& path) {
    const QString file = QFileInfo(path).fileName();
    banner_->showOffer(tr("Wrote %1").arg(file),
                       {{tr("Open"), [this, path, file] { // it took a while
                           if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path)))
                             banner_->showError(tr("No program opens %1 from here").arg(file));
                         }}});
  });
  connect(theme_, &ThemeFlow::changed, evaluation_.get(), &EvaluationFlow::setDark);
}

void MainWindow::connectPreview() {
  connect(pipeline_, &PipelinePanel::runRequested, this, [this](const Step& last) {
    actions_->guarded(
        [&] {
          reconstruct(&last);
          return true;
        },
        Refusal::inBanner);
  });
  connect(preview_.get(), &PreviewFlow::failed, banner_,
          [this](const QString& message) { banner_->showError(message); });
  connect(preview_.get(), &PreviewFlow::noted, status_, &StatusLine::showNote);
  connect(preview_.get(), &PreviewFlow::changed, this, &MainWindow::refreshHint);
  connect(preview_.get(), &PreviewFlow::changed, this, [this] {
    const std::optional<Outcome>& shown = preview_->shown();
    if (shown && preview_->isOther())
      valueColors_->setPreviewed(shown->contracted, shown->points);
    else
      valueColors_->setPreviewed(nullptr, {});
  });
  connect(theme_, &ThemeFlow::changed, judge_.get(), &JudgeFlow::setDark);
  projects_->keep({.name = "choices",
                   .text = [this] { return choices_->text(); },
                   .show = [this](const std::string& text) { choices_->show(text); }});
  connect(choices_.get(), &ChoicesFlow::changed, this, [this] {
    evaluation_->setChoices(choices_->records());
    projects_->noteChange();
  });
  connect(choices_.get(), &ChoicesFlow::noted, this, [this](const QString& message) {
    if (banner_->isError()) banner_->hide(); // of what kept it from being recorded before
    status_->showNote(message);
  });
  connect(sight_.get(), &SightFlow::noted, status_, &StatusLine::showNote);
  connect(sight_.get(), &SightFlow::failed, banner_,
          [this](const QString& message) { banner_->showError(message); });
  connect(sweep_.get(), &SweepFlow::taken, densities_.get(), &DensityFlow::refresh);
  connect(presets_.get(), &PresetFlow::chosen, densities_.get(), &DensityFlow::refresh);
  connect(sweep_.get(), &SweepFlow::taken, preview_.get(), &PreviewFlow::askAgain);
  connect(sweep_.get(), &SweepFlow::taken, projects_.get(), &ProjectFlow::noteChange);
  connect(presets_.get(), &PresetFlow::chosen, preview_.get(), &PreviewFlow::askAgain);
  connect(states_.get(), &StatesFlow::noted, status_, &StatusLine::showNote);
}

} // namespace espalier
