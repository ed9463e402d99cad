// The parts of the window: here they are made, each with what it works with, and joined where one
// needs what another does. Actions are listed, and panels lie side by side, in this order.
#include "app/window/align/registration_flow.h"
#include "app/window/edit/clean_flow.h"
#include "app/window/edit/editing.h"
#include "app/window/edit/history_flow.h"
#include "app/window/edit/inspector_flow.h"
#include "app/window/edit/node_table_flow.h"
#include "app/window/edit/organ_flow.h"
#include "app/window/edit/point_states.h"
#include "app/window/edit/points_flow.h"
#include "app/window/edit/radius_flow.h"
#include "app/window/edit/snap_flow.h"
#include "app/window/edit/stand_flow.h"
#include "app/window/edit/trace_flow.h"
#include "app/window/edit/unit_flow.h"
#include "app/window/edit_flow.h"
#include "app/window/evaluate/consensus_flow.h"
#include "app/window/evaluate/envelope_flow.h"
#include "app/window/evaluate/evaluation_flow.h"
#include "app/window/evaluate/reference_flow.h"
#include "app/window/evaluate/versions_flow.h"
#include "app/window/files/file_flow.h"
#include "app/window/files/picture_flow.h"
#include "app/window/files/plot_flow.h"
#include "app/window/files/points_export_flow.h"
#include "app/window/files/project_flow.h"
#include "app/window/files/recent_files.h"
#include "app/window/files/sample_flow.h"
#include "app/window/files/turntable_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/help_flow.h"
#include "app/window/frame/ignoring_steps.h"
#include "app/window/frame/language_flow.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/frame/panel_focus.h"
#include "app/window/frame/panel_keys.h"
#include "app/window/frame/theme_flow.h"
#include "app/window/frame/tour_flow.h"
#include "app/window/main_window.h"
#include "app/window/preview/choices_flow.h"
#include "app/window/preview/density_flow.h"
#include "app/window/preview/judge_flow.h"
#include "app/window/preview/kind_flow.h"
#include "app/window/preview/measure_flow.h"
#include "app/window/preview/pipeline_flow.h"
#include "app/window/preview/preset_flow.h"
#include "app/window/preview/preview_flow.h"
#include "app/window/preview/reconstruct_flow.h"
#include "app/window/preview/sight_flow.h"
#include "app/window/preview/states_flow.h"
#include "app/window/preview/sweep_flow.h"
#include "app/window/review/asking_flow.h"
#include "app/window/review/doubts_flow.h"
#include "app/window/review/expected_errors_flow.h"
#include "app/window/review/findings_flow.h"
#include "app/window/review/review_flow.h"
#include "app/window/review/seal_flow.h"
#include "app/window/review/suspects_flow.h"
#include "app/window/review/worklist_flow.h"
#include "app/window/view/close_look_flow.h"
#include "app/window/view/explained_flow.h"
#include "app/window/view/hidden_points.h"
#include "app/window/view/hull_flow.h"
#include "app/window/view/saved_views.h"
#include "app/window/view/shown_flow.h"
#include "app/window/view/space_mouse_flow.h"
#include "app/window/view/two_views_flow.h"
#include "app/window/view/value_colors.h"
#include "app/window/view/view_moves.h"
#include "app/window/view/view_options.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/review_panel.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_line.h"
#include "ui/view/plant_view.h"

#include <QDateTime>
#include <QTimer>

namespace espalier {

void MainWindow::makeParts() {
  auto* pipeline = new PipelinePanel(document_);
  auto* inspector = new InspectorPanel(document_);
  makeFiles(*pipeline);
  makeEditing(*pipeline, *inspector);
  makePanels(*pipeline, *inspector);
  makeReview();
  makePoints(*pipeline);
  makeViews();
  makeEvaluation();
  makePreview(*pipeline);
  parts_.make<ThemeFlow>(ThemeFlow::Parts{*actions_, settings_, *this});
  parts_.make<LanguageFlow>(*actions_, settings_);
  const auto hasPreview = [this] { return parts_.get<Editing>().hasPreview(); };
  new PanelKeys(this, hasPreview);
  parts_.make<PanelFocus>(PanelFocus::Parts{*actions_, *this,
                                            [this] {
                                              PlantView& view = parts_.get<Editing>().activeView();
                                              if (view.isVisible()) view.setFocus();
                                            },
                                            hasPreview});
  parts_.make<TourFlow>(TourFlow::Parts{document_, *actions_, settings_, *this});
  parts_.make<HelpFlow>(HelpFlow::Parts{*actions_, settings_, *this, [this] {
                                          return document_.isEmpty()
                                                     ? QStringLiteral("first-plant.md")
                                                     : parts_.get<Editing>().manualPlace();
                                        }});
  joinEdits();
  joinFiles();
  joinReview();
  joinPipeline();
  joinPreview();
  joinViews();
  auto& projects = parts_.get<ProjectFlow>();
  const WindowPart& views = parts_.get<ViewOptions>();
  for (const auto& part : parts_)
    if (part.get() != &views) projects.keep(*part);
  projects.keep(views); // shown last: what points up turns the view
}

void MainWindow::makeFiles(PipelinePanel& pipeline) {
  auto& projects =
      parts_.make<ProjectFlow>(ProjectFlow::Parts{document_, jobs_, *recent_, settings_, *this});
  parts_.make<FileFlow>(
      FileFlow::Parts{document_, jobs_, *actions_, projects, *recent_, settings_, *this,
                      [this] { return view_->clip().box; },
                      [this] { return parts_.get<RegistrationFlow>().mayLose(); }});
  auto& sample = parts_.make<SampleFlow>(*actions_, jobs_, settings_);
  connect(&sample, &SampleFlow::made, this, [this](const QString& path) { open({path}); });
  connect(start_, &StartPage::sampleRequested, (*actions_)["sample_plant"], &QAction::trigger);
  parts_.make<EditFlow>(document_, *actions_);
  parts_.make<ReconstructFlow>(ReconstructFlow::Parts{document_, jobs_, *actions_, pipeline});
}

void MainWindow::makeEditing(PipelinePanel& pipeline, InspectorPanel& inspector) {
  auto& editing = parts_.make<Editing>(document_, *view_, *actions_);
  parts_.make<TraceFlow>(TraceFlow::Parts{document_, *view_, *actions_, editing, jobs_,
                                          [&pipeline] { return pipeline.options(); }});
  parts_.make<SnapFlow>(document_, *actions_, editing, settings_);
  parts_.make<StandFlow>(StandFlow::Parts{document_, *view_, pipeline, *actions_, editing});
  parts_.make<UnitFlow>(document_, *actions_, inspector, *this);
  parts_.make<RadiusFlow>(
      RadiusFlow::Parts{document_, jobs_, *actions_, *view_, inspector.crossSection()});
  parts_.make<ViewOptions>(*view_, *actions_, settings_);
}

void MainWindow::makePanels(PipelinePanel& pipeline, InspectorPanel& inspector) {
  const PanelDock::Parts window{*actions_, settings_, *this};
  parts_.make<PipelineFlow>(
      PipelineFlow::Parts{document_, pipeline, parts_.get<ReconstructFlow>(), window});
  parts_.make<InspectorFlow>(InspectorFlow::Parts{document_, *view_, inspector, window});
  addLayoutAction();
}

void MainWindow::makeReview() {
  const auto isLeftOut = [this](const Finding& finding) {
    return parts_.get<FindingsFlow>().isIgnored(finding) ||
           parts_.get<DoubtsFlow>().isLeftOut(finding);
  };
  const auto addKnown = [this](ToSeal& from) {
    from.limits = parts_.get<FindingsFlow>().limits();
    const auto& reference = parts_.get<ReferenceFlow>();
    from.how = parts_.get<EvaluationFlow>().options();
    if (reference.isVersion()) return; // it is no structure of another
    from.reference = reference.skeleton();
    from.referenceName = reference.name().toStdString();
  };
  parts_.make<SealFlow>(SealFlow::Parts{document_, *actions_, parts_.get<ProjectFlow>(), jobs_,
                                        *banner_, *this, addKnown, isLeftOut,
                                        [this] { return parts_.get<DoubtsFlow>().questions(); }});
  auto& editing = parts_.get<Editing>();
  auto& distances = parts_.make<ScanDistances>(document_, queue_);
  auto& errors = parts_.make<ExpectedErrorsFlow>(ExpectedErrorsFlow::Parts{
      document_, queue_, distances, [this] { return parts_.get<FindingsFlow>().limits(); }});
  auto& ignoring = parts_.make<IgnoringSteps>(document_);
  parts_.make<ReviewFlow>(
      ReviewFlow::Parts{
          document_, *view_, *actions_, editing, settings_, *this, reveal(),
          [this]() -> const std::vector<NodeId>& { return parts_.get<ShownFlow>().hidden(); },
          errors, isLeftOut,
          [this](const Finding& finding, bool isIgnored) {
            auto& findings = parts_.get<FindingsFlow>();
            isIgnored ? findings.ignore(finding) : findings.stopIgnoring(finding);
          },
          ignoring, [this] { return parts_.get<AskingFlow>().lookAgain(); }},
      (*actions_)["sign_structure"]);
  const PanelDock::Parts window{*actions_, settings_, *this};
  parts_.make<ShownFlow>(ShownFlow::Parts{document_, *view_, *actions_, editing, window});
}

Reveal MainWindow::reveal() {
  return [this](const std::vector<NodeId>& nodes, const std::vector<Eigen::Vector3d>& places,
                const Camera& camera) {
    return parts_.get<ShownFlow>().reveal(nodes, places, camera);
  };
}

void MainWindow::makePoints(PipelinePanel& pipeline) {
  auto& editing = parts_.get<Editing>();
  auto& states = parts_.make<PointStates>(document_, *view_);
  auto& points = parts_.make<PointsFlow>(PointsFlow::Parts{document_, *actions_, editing, states});
  parts_.make<OrganFlow>(OrganFlow::Parts{document_, queue_, *actions_, editing, points.tool(),
                                          [&pipeline] { return pipeline.options(); }});
  parts_.make<CleanFlow>(
      CleanFlow::Parts{document_, queue_, points, {*actions_, settings_, *this}});
  parts_.make<PlotFlow>(
      PlotFlow::Parts{document_,
                      queue_,
                      {*actions_, settings_, *this},
                      [&pipeline] { return pipeline.options(); },
                      [this](const QString& folder) { parts_.get<WorklistFlow>().list(folder); }});
  parts_.make<SavedViews>(SavedViews::Parts{*view_, parts_.get<ViewOptions>(),
                                            parts_.get<ShownFlow>(), *actions_, *this});
  auto& distances = parts_.get<ScanDistances>();
  auto& findings =
      parts_.make<FindingsFlow>(FindingsFlow::Parts{document_, queue_, distances, *this});
  auto& explained = parts_.make<ExplainedFlow>(ExplainedFlow::Parts{
      document_, states, *actions_, distances, settings_, *this,
      [&findings] { return findings.usualReach(); }, [&findings] { return findings.sensitivity(); },
      [&findings](double value) { findings.setSensitivity(value); }});
  connect(&findings, &FindingsFlow::limitsChanged, &explained, &ExplainedFlow::takeLimits);
  connect(&findings, &FindingsFlow::limitsChanged, &parts_.get<ExpectedErrorsFlow>(),
          &ExpectedErrorsFlow::findAnew);
  auto& doubts = parts_.make<DoubtsFlow>(DoubtsFlow::Parts{
      document_, queue_, distances, [&findings] { return findings.limits(); },
      [this] { return parts_.get<ReviewFlow>().reviewer(); },
      [this](const std::string& name) { parts_.get<ProjectFlow>().writeNow(name); }});
  connect(&findings, &FindingsFlow::limitsChanged, &doubts, &DoubtsFlow::findAnew);
  auto& asking = parts_.make<AskingFlow>(
      AskingFlow::Parts{document_, *view_, *actions_, editing, doubts, distances, *this, reveal()});
  parts_.make<SuspectsFlow>(SuspectsFlow::Parts{
      document_, *view_, *actions_, distances, findings, doubts, asking, settings_, *this, reveal(),
      [&editing] { editing.actOnSelected(); }, parts_.get<IgnoringSteps>()});
  parts_.make<HiddenPoints>(
      HiddenPoints::Parts{document_, parts_.get<ShownFlow>(), distances, states});
  parts_.make<PresetFlow>(PresetFlow::Parts{pipeline, *actions_, settings_, *this, document_});
  parts_.make<KindFlow>(KindFlow::Parts{document_, queue_, pipeline, *actions_});
  parts_.make<PointsExportFlow>(PointsExportFlow::Parts{document_, jobs_, *actions_, *this});
  parts_.make<PictureFlow>(PictureFlow::Parts{document_, *view_, *actions_, *this});
  parts_.make<TurntableFlow>(TurntableFlow::Parts{document_, *view_, jobs_, *actions_, *this});
  parts_.make<HullFlow>(HullFlow::Parts{document_, queue_, *view_, *actions_, editing, distances});
}

void MainWindow::makeViews() {
  const PanelDock::Parts window{*actions_, settings_, *this};
  auto& editing = parts_.get<Editing>();
  auto& twoViews = parts_.make<TwoViewsFlow>(
      TwoViewsFlow::Parts{*view_, *views_, *actions_, editing, settings_});
  parts_.make<CloseLookFlow>(CloseLookFlow::Parts{document_, *view_, *actions_, editing, twoViews});
  parts_.make<ViewMoves>(*actions_, editing);
  parts_.make<SpaceMouseFlow>(SpaceMouseFlow::Parts{editing, *actions_, *this});
  parts_.make<ValueColors>(
      ValueColors::Parts{document_, *view_, *actions_, parts_.get<ViewOptions>(),
                         parts_.get<ScanDistances>(), parts_.get<OrganFlow>()});
  parts_.make<HistoryFlow>(HistoryFlow::Parts{document_, editing, window});
  parts_.make<NodeTableFlow>(NodeTableFlow::Parts{document_, editing, window});
  parts_.make<WorklistFlow>(
      WorklistFlow::Parts{document_, jobs_, window,
                          [this](const QString& file) { parts_.get<FileFlow>().openPlant(file); },
                          [this](const QString& file) { parts_.get<ReferenceFlow>().load(file); }});
}

void MainWindow::makeEvaluation() {
  const PanelDock::Parts window{*actions_, settings_, *this};
  auto& reference = parts_.make<ReferenceFlow>(
      ReferenceFlow::Parts{document_, *view_, jobs_, *actions_, settings_, *this,
                           [this] { return parts_.get<ProjectFlow>().scanReference(); }});
  parts_.make<VersionsFlow>(
      VersionsFlow::Parts{document_, parts_.get<ProjectFlow>(), reference, *actions_, *this});
  parts_.make<ConsensusFlow>(
      ConsensusFlow::Parts{document_, parts_.get<ProjectFlow>(), reference, jobs_, *actions_});
  parts_.make<EvaluationFlow>(EvaluationFlow::Parts{document_, *view_, jobs_, parts_.get<Editing>(),
                                                    reference, parts_.get<IgnoringSteps>(),
                                                    window});
  parts_.make<EnvelopeFlow>(EnvelopeFlow::Parts{document_, *view_, queue_, window});
  parts_.make<RegistrationFlow>(
      RegistrationFlow::Parts{document_, *view_, jobs_, parts_.get<Editing>(),
                              parts_.get<ProjectFlow>(), parts_.get<FileFlow>(), window});
}

void MainWindow::makePreview(PipelinePanel& pipeline) {
  const PanelDock::Parts window{*actions_, settings_, *this};
  auto& editing = parts_.get<Editing>();
  auto& reconstruct = parts_.get<ReconstructFlow>();
  auto& reference = parts_.get<ReferenceFlow>();
  auto& evaluation = parts_.get<EvaluationFlow>();
  auto& preview = parts_.make<PreviewFlow>(
      PreviewFlow::Parts{document_, queue_, *view_, pipeline, *actions_, editing, reconstruct});
  auto& states = parts_.make<StatesFlow>(
      StatesFlow::Parts{document_, queue_, *view_, *actions_, reconstruct, preview,
                        parts_.get<TwoViewsFlow>(), *centralWidget()});
  parts_.make<DensityFlow>(document_, queue_, pipeline);
  parts_.make<MeasureFlow>(document_, queue_, pipeline);
  auto& judge = parts_.make<JudgeFlow>(JudgeFlow::Parts{
      document_, queue_, *view_, reconstruct, preview, states, reference, evaluation, window});
  auto& sweep = parts_.make<SweepFlow>(SweepFlow::Parts{
      document_, queue_, *view_, pipeline, reconstruct, reference, evaluation, window});
  parts_.make<ChoicesFlow>(ChoicesFlow::Parts{*actions_, judge, sweep});
  parts_.make<SightFlow>(
      SightFlow::Parts{document_, queue_, *view_, pipeline, *actions_, editing, preview});
}

void MainWindow::joinEdits() {
  auto& editing = parts_.get<Editing>();
  auto& points = parts_.get<PointsFlow>();
  auto& shown = parts_.get<ShownFlow>();
  auto& registration = parts_.get<RegistrationFlow>();
  parts_.get<EditFlow>().join({editing, parts_.get<PreviewFlow>(), shown, parts_.get<ProjectFlow>(),
                               registration, parts_.get<AskingFlow>(), parts_.get<IgnoringSteps>(),
                               [this] { return banner_->dismiss(); }});
  connect(&points, &PointsFlow::changed, &shown,
          [this, &shown] { shown.setPointsIsolated(parts_.get<PointStates>().isIsolated()); });
  connect(&registration, &RegistrationFlow::begun, this, &MainWindow::refreshEnabled);
  connect(&registration, &RegistrationFlow::ended, this, &MainWindow::refreshEnabled);
  connect(&editing, &Editing::contextMenuRequested, this, &MainWindow::showContextMenu);
}

void MainWindow::joinFiles() {
  auto& projects = parts_.get<ProjectFlow>();
  auto& files = parts_.get<FileFlow>();
  auto& reference = parts_.get<ReferenceFlow>();
  const auto showPlant = [this] {
    banner_->hide();
    const auto* scan = document_.scan();
    parts_.get<ViewOptions>().setAvailable(scan != nullptr && !scan->cloud()->intensities().empty(),
                                           scan != nullptr && !scan->cloud()->colors().empty());
    refreshEmptiness();
  };
  connect(&projects, &ProjectFlow::opened, this, showPlant);
  connect(&files, &FileFlow::opened, this, showPlant);
  connect(&files, &FileFlow::opened, view_, &PlantView::faceAll); // after it has its size
  connect(&files, &FileFlow::closed, this, &MainWindow::refreshEmptiness);
  connect(&projects, &ProjectFlow::scanFound, this, [this, showPlant] {
    showPlant();
    if (document_.skeleton().isEmpty()) view_->faceAll(); // there was nothing to look at
  });
  connect(&projects, &ProjectFlow::scanGrown, this, showPlant);
  connect(&files, &FileFlow::registrationAsked, this, [this](const QString& path) {
    guarded([&] { parts_.get<RegistrationFlow>().begin(path); });
  });
  connect(&files, &FileFlow::movedOntoScan, view_, &PlantView::frameAll);
  connect(&projects, &ProjectFlow::workedOn, this, &MainWindow::workedOn);
  connect(&projects, &ProjectFlow::chosen, this, [this](const QString& path) { open({path}); });
  connect(&projects, &ProjectFlow::sessionsChanged, start_, [this, &projects] {
    QStringList texts;
    QStringList paths;
    for (const Session& session : projects.sessions().waiting()) {
      texts.append(describe(session, QDateTime::currentDateTime()));
      paths.append(session.path);
    }
    start_->setSessions(texts, paths);
  });
  connect(this, &MainWindow::openRequested, &files,
          [this, &files](const QStringList& paths) { guarded([&] { files.open(paths); }); });
  connect(&reference, &ReferenceFlow::openRequested, this, &MainWindow::open);
  connect(this, &MainWindow::dropped, &reference, [this, &reference](const QStringList& paths) {
    if (reference.takesDropped(paths)) return;
    // Later, as it may ask: the program that they were dragged from waits for the drop to end.
    QTimer::singleShot(0, this, [this, paths] { open(paths); });
  });
}

void MainWindow::joinReview() {
  auto& seals = parts_.get<SealFlow>();
  auto& review = parts_.get<ReviewFlow>();
  auto& editing = parts_.get<Editing>();
  const auto showSeal = [&review, &seals] { review.panel().showSeal(seals.text()); };
  seals.setSigner(review.reviewer());
  connect(&seals, &SealFlow::changed, &review, showSeal);
  connect(&seals, &SealFlow::signerChanged, &review, &ReviewFlow::setReviewer);
  connect(&review, &ReviewFlow::reviewerChanged, &seals, &SealFlow::setSigner);
  connect(&parts_.get<ProjectFlow>(), &ProjectFlow::authorChosen, &review,
          &ReviewFlow::setReviewer);
  connect(&parts_.get<HelpFlow>(), &HelpFlow::keysAsked, &parts_.get<AskingFlow>(),
          &AskingFlow::stopAsking); // which has keys of others
  connect(&editing, &Editing::hintChanged, &review, [&review, &editing] {
    review.setInGesture(editing.isPending());
    review.setEnterTaken(editing.offered().has_value());
  });
  showSeal();
}

void MainWindow::joinPipeline() {
  auto& reconstruct = parts_.get<ReconstructFlow>();
  auto& densities = parts_.get<DensityFlow>();
  auto& preview = parts_.get<PreviewFlow>();
  auto& sweep = parts_.get<SweepFlow>();
  auto& presets = parts_.get<PresetFlow>();
  connect(&reconstruct, &ReconstructFlow::starting, this, [this] {
    for (const auto& part : parts_)
      part->stop(); // what the preview has computed is at hand
  });
  connect(&reconstruct, &ReconstructFlow::done, this,
          [this, &reconstruct](const QString& message, const std::string& last) {
            reconstruct.showDone(last);
            showNotice({.text = message, .isStep = true});
          });
  connect(&reconstruct, &ReconstructFlow::usedChanged, &reconstruct, &ReconstructFlow::showUsed);
  auto& evaluation = parts_.get<EvaluationFlow>();
  connect(&reconstruct, &ReconstructFlow::usedChanged, &evaluation, [&reconstruct, &evaluation] {
    evaluation.setMade(reconstruct.isUsedKnown() ? std::optional(reconstruct.used())
                                                 : std::nullopt);
  });
  connect(&parts_.get<PipelineFlow>(), &PipelineFlow::shown, &preview, &PreviewFlow::keepChoices);
  connect(&sweep, &SweepFlow::taken, &densities, &DensityFlow::refresh);
  connect(&presets, &PresetFlow::chosen, &densities, &DensityFlow::refresh);
  connect(&sweep, &SweepFlow::taken, &preview, &PreviewFlow::askAgain);
  connect(&presets, &PresetFlow::chosen, &preview, &PreviewFlow::askAgain);
}

void MainWindow::joinPreview() {
  auto& preview = parts_.get<PreviewFlow>();
  auto& colors = parts_.get<ValueColors>();
  auto& choices = parts_.get<ChoicesFlow>();
  auto& evaluation = parts_.get<EvaluationFlow>();
  connect(&preview, &PreviewFlow::changed, &colors, [&preview, &colors] {
    const std::optional<Outcome>& shown = preview.shown();
    if (shown && preview.isOther())
      colors.setPreviewed(shown->contracted, shown->points);
    else
      colors.setPreviewed(nullptr, {});
  });
  connect(&choices, &ChoicesFlow::changed, &evaluation,
          [&choices, &evaluation] { evaluation.setChoices(choices.records()); });
  connect(&choices, &ChoicesFlow::noted, banner_, [this] {
    if (banner_->isError()) banner_->hide(); // of what kept it from being recorded before
  });
}

/// Its job blocks nothing, so a job that does is shown instead of it.
void MainWindow::joinOrgans() {
  JobSlot& job = parts_.get<OrganFlow>().job();
  const auto isShown = [this] { return !jobs_.isBusy(); };
  connect(&job, &JobSlot::started, this, [this, &job, isShown] {
    if (isShown()) status_->showJob(job.name());
  });
  connect(&job, &JobSlot::progressed, this, [this, isShown](double done, const QString& stage) {
    if (isShown()) status_->showProgress(done, stage);
  });
  connect(&job, &JobSlot::finished, this, [this, isShown] {
    if (isShown()) status_->hideJob();
  });
  connect(status_, &StatusLine::cancelRequested, this, [this, isShown] {
    if (isShown()) parts_.get<OrganFlow>().giveUp();
  });
}

void MainWindow::joinViews() {
  auto& envelope = parts_.get<EnvelopeFlow>();
  connect(&envelope, &EnvelopeFlow::changed, &parts_.get<EvaluationFlow>(),
          [this, &envelope] { parts_.get<EvaluationFlow>().setEnvelope(envelope.reported()); });
  auto& theme = parts_.get<ThemeFlow>();
  connect(&theme, &ThemeFlow::changed, view_, &PlantView::setDark);
  connect(&theme, &ThemeFlow::changed, &parts_.get<EvaluationFlow>(), &EvaluationFlow::setDark);
  connect(&theme, &ThemeFlow::changed, &parts_.get<JudgeFlow>(), &JudgeFlow::setDark);
  connect(&theme, &ThemeFlow::changed, &parts_.get<ValueColors>(), &ValueColors::setDark);
  theme.start();
  joinOrgans();
}

} // namespace espalier
