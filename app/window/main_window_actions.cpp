#include "app/window/action_set.h"
#include "app/window/choices_flow.h"
#include "app/window/close_look_flow.h"
#include "app/window/density_flow.h"
#include "app/window/editing.h"
#include "app/window/evaluation_flow.h"
#include "app/window/explained_flow.h"
#include "app/window/file_flow.h"
#include "app/window/findings_flow.h"
#include "app/window/history_flow.h"
#include "app/window/hull_flow.h"
#include "app/window/judge_flow.h"
#include "app/window/main_window.h"
#include "app/window/node_table_flow.h"
#include "app/window/panel_dock.h"
#include "app/window/point_states.h"
#include "app/window/points_flow.h"
#include "app/window/preset_flow.h"
#include "app/window/preview_flow.h"
#include "app/window/project_flow.h"
#include "app/window/radius_flow.h"
#include "app/window/reference_flow.h"
#include "app/window/review_flow.h"
#include "app/window/saved_views.h"
#include "app/window/seal_flow.h"
#include "app/window/shown_flow.h"
#include "app/window/sight_flow.h"
#include "app/window/snap_flow.h"
#include "app/window/stand_flow.h"
#include "app/window/states_flow.h"
#include "app/window/sweep_flow.h"
#include "app/window/theme_flow.h"
#include "app/window/trace_flow.h"
#include "app/window/two_views_flow.h"
#include "app/window/unit_flow.h"
#include "app/window/value_colors.h"
#include "app/window/view_options.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/key_bindings.h"
#include "ui/dialogs/manual_window.h"
#include "ui/dialogs/shortcut_sheet.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QCoreApplication>
#include <QMessageBox>
#include <QSettings>

namespace espalier {

void MainWindow::addActions() {
  addFileActions();
  addProjectActions();
  addEditActions();
  editing_ = std::make_unique<Editing>(document_, *view_, *actions_, nullptr);
  traces_ = std::make_unique<TraceFlow>(TraceFlow::Parts{
      document_, *view_, *actions_, *editing_, jobs_, [this] { return pipeline_->options(); }});
  connect(traces_.get(), &TraceFlow::failed, this,
          [this](const QString& message) { banner_->showError(message); });
  snaps_ = std::make_unique<SnapFlow>(document_, *actions_, *editing_, settings_);
  stand_ = std::make_unique<StandFlow>(
      StandFlow::Parts{document_, *view_, *pipeline_, *actions_, *editing_});
  units_ = std::make_unique<UnitFlow>(document_, *actions_, *inspector_, *this);
  radius_ = std::make_unique<RadiusFlow>(
      RadiusFlow::Parts{document_, jobs_, *actions_, *view_, inspector_->crossSection()});
  options_ = std::make_unique<ViewOptions>(*view_, *actions_, settings_, nullptr);
  const PanelDock::Parts panels{*actions_, settings_, *this};
  addPanels();
  seals_ = std::make_unique<SealFlow>(
      SealFlow::Parts{document_, *actions_, *projects_, *banner_, *this});
  const auto reveal = [this](const std::vector<NodeId>& nodes,
                             const std::vector<Eigen::Vector3d>& places, const Camera& camera) {
    return shown_->reveal(nodes, places, camera);
  };
  review_ = std::make_unique<ReviewFlow>(
      ReviewFlow::Parts{document_, *view_, *actions_, *editing_, settings_, *this, reveal,
                        [this]() -> const std::vector<NodeId>& { return shown_->hidden(); }},
      (*actions_)["sign_structure"]);
  shown_ = std::make_unique<ShownFlow>(
      ShownFlow::Parts{document_, *view_, *actions_, *editing_, panels});
  pointStates_ = std::make_unique<PointStates>(document_, *view_);
  points_ = std::make_unique<PointsFlow>(
      PointsFlow::Parts{document_, *actions_, *editing_, *pointStates_});
  savedViews_ =
      std::make_unique<SavedViews>(SavedViews::Parts{*view_, *options_, *shown_, *actions_, *this});
  distances_ = std::make_unique<ScanDistances>(document_);
  findings_ = std::make_unique<FindingsFlow>(
      FindingsFlow::Parts{document_, *view_, *actions_, *distances_, settings_, *this, reveal});
  explained_ = std::make_unique<ExplainedFlow>(
      ExplainedFlow::Parts{document_, *pointStates_, *actions_, *distances_, settings_, *this});
  presets_ = std::make_unique<PresetFlow>(
      PresetFlow::Parts{*pipeline_, *actions_, *banner_, settings_, *this, document_});
  hulls_ = std::make_unique<HullFlow>(
      HullFlow::Parts{document_, *view_, *actions_, *editing_, *distances_});
  twoViews_ = std::make_unique<TwoViewsFlow>(
      TwoViewsFlow::Parts{*view_, *views_, *actions_, *editing_, settings_});
  closeLook_ = std::make_unique<CloseLookFlow>(
      CloseLookFlow::Parts{document_, *view_, *actions_, *editing_, *twoViews_});
  valueColors_ = std::make_unique<ValueColors>(
      ValueColors::Parts{document_, *view_, *actions_, *options_, *distances_});
  history_ = std::make_unique<HistoryFlow>(HistoryFlow::Parts{document_, *editing_, panels});
  nodeTable_ = std::make_unique<NodeTableFlow>(NodeTableFlow::Parts{document_, *editing_, panels});
  reference_ = std::make_unique<ReferenceFlow>(
      ReferenceFlow::Parts{document_, *view_, jobs_, *actions_, settings_, *this});
  evaluation_ = std::make_unique<EvaluationFlow>(
      EvaluationFlow::Parts{document_, *view_, jobs_, *editing_, *reference_, panels});
  preview_ = std::make_unique<PreviewFlow>(
      PreviewFlow::Parts{document_, *view_, *pipeline_, *actions_, *editing_, *reconstruct_});
  states_ = std::make_unique<StatesFlow>(StatesFlow::Parts{
      document_, *view_, *actions_, *reconstruct_, *preview_, *twoViews_, *centralWidget()});
  densities_ = std::make_unique<DensityFlow>(document_, *pipeline_);
  judge_ = std::make_unique<JudgeFlow>(JudgeFlow::Parts{
      document_, *view_, *reconstruct_, *preview_, *states_, *reference_, *evaluation_, panels});
  sweep_ = std::make_unique<SweepFlow>(SweepFlow::Parts{
      document_, *view_, *pipeline_, *reconstruct_, *reference_, *evaluation_, panels});
  choices_ = std::make_unique<ChoicesFlow>(ChoicesFlow::Parts{*actions_, *judge_, *sweep_});
  sight_ = std::make_unique<SightFlow>(
      SightFlow::Parts{document_, *view_, *pipeline_, *actions_, *editing_, *preview_});
  theme_ = new ThemeFlow({*actions_, settings_, *this});
  addHelpActions();
  keys_ = new KeyBindings(actions_->all(), {"leave", "accept"}, settings_, this);
}

void MainWindow::addFileActions() {
  actions_->beginSection(tr("File"));
  actions_->add({.id = "open",
                 .text = tr("&Open…"),
                 .help = tr("Opens a scan, or a skeleton over it"),
                 .icon = "open",
                 .keys = QKeySequence::Open},
                [this] { files_->chooseAndOpen(); });
  actions_->add({.id = "save",
                 .text = tr("&Save"),
                 .help = tr("Saves the skeleton"),
                 .icon = "save",
                 .keys = QKeySequence::Save},
                [this] { files_->save(); });
  actions_->add({.id = "save_as",
                 .text = tr("Save &As…"),
                 .help = tr("Saves the skeleton under another name"),
                 .icon = "save_as",
                 .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
                [this] { files_->saveAs(); });
  actions_->add({.id = "close_plant",
                 .text = tr("&Close Plant"),
                 .help = tr("Puts scan and skeleton away"),
                 .keys = QKeySequence(Qt::CTRL | Qt::Key_W)},
                [this] { closePlant(); });
  actions_->add({.id = "quit",
                 .text = tr("&Quit"),
                 .help = tr("Leaves the program"),
                 .keys = QKeySequence(Qt::CTRL | Qt::Key_Q)},
                [this] { close(); });
}

void MainWindow::addProjectActions() {
  actions_->add({.id = "new_plant",
                 .text = tr("&New"),
                 .help = tr("Puts this plant away and begins another"),
                 .keys = QKeySequence::New},
                [this] { closePlant(); });
  actions_->add({.id = "save_project_as",
                 .text = tr("Save &Project As…"),
                 .help = tr("Keeps plant, scan and history in one file, which saves itself"),
                 .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S)},
                [this] { projects_->saveAs(); });
  actions_->add({.id = "keep_scan",
                 .text = tr("Keep the Scan in the Project"),
                 .help = tr("Writes the scan into the project file, which then needs no other"),
                 .isCheckable = true},
                [this] {
                  refreshTitle(); // it is checked once it is done
                  projects_->keepScan(!projects_->isScanKept());
                });
  actions_->add({.id = "compact_project",
                 .text = tr("Compact Project"),
                 .help = tr("Gives back the room that the project file no longer uses")},
                [this] { projects_->compact(); });
  actions_->add({.id = "export_structure",
                 .text = tr("&Export Structure…"),
                 .help = tr("Writes a copy of the skeleton, as MTG or another format"),
                 .keys = QKeySequence(Qt::CTRL | Qt::Key_E)},
                [this] { files_->exportStructure(); });
}

void MainWindow::addEditActions() {
  actions_->beginSection(tr("Edit"));
  QUndoStack& stack = document_.undoStack();
  QAction* undo = actions_->add({.id = "undo",
                                 .text = tr("&Undo"),
                                 .help = tr("Takes the last edit back"),
                                 .icon = "undo",
                                 .keys = QKeySequence(Qt::CTRL | Qt::Key_Z)},
                                [this] { undoStep(); });
  QAction* redo = actions_->add({.id = "redo",
                                 .text = tr("&Redo"),
                                 .help = tr("Makes the edit again"),
                                 .icon = "redo",
                                 .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)},
                                [this] { redoStep(); });
  redo->setShortcuts({redo->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  undo->setEnabled(false);
  redo->setEnabled(false);
  connect(&stack, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
  connect(&stack, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
  connect(&stack, &QUndoStack::undoTextChanged, undo, [undo](const QString& step) {
    undo->setText(step.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(step));
  });
  connect(&stack, &QUndoStack::redoTextChanged, redo, [redo](const QString& step) {
    redo->setText(step.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(step));
  });
  actions_->add({.id = "select_all",
                 .text = tr("Select &All"),
                 .help = tr("Selects all nodes but the hidden ones"),
                 .keys = QKeySequence::SelectAll},
                [this] { document_.selection().set(shown_->shownNodes()); });
  actions_->add({.id = "leave",
                 .text = tr("Leave"),
                 .help = tr("Leaves the gesture, the tool, or the selection"),
                 .keys = Qt::Key_Escape},
                [this] { leave(); });
  actions_->add({.id = "reconstruct",
                 .text = tr("Re&construct"),
                 .help = tr("Makes the skeleton from the scan"),
                 .icon = "reconstruct",
                 .keys = QKeySequence(Qt::CTRL | Qt::Key_R)},
                [this] { reconstruct(); });
}

void MainWindow::addPanels() {
  // Knobs stay in reach while what they do is judged below the view.
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  const PanelDock::Parts parts{*actions_, settings_, *this};
  const auto add = [&](const QString& id, const QString& title, Qt::Key key,
                       const PanelDock::Place& place, QWidget* panel) {
    return new PanelDock(parts,
                         {.id = id,
                          .title = title,
                          .text = title,
                          .help = tr("Shows or hides this panel"),
                          .keys = QKeySequence(key)},
                         place, panel, this);
  };
  pipelineDock_ = add("pipeline", tr("Pipeline"), Qt::Key_F6,
                      {.side = Qt::LeftDockWidgetArea, .size = 230, .isShown = true}, pipeline_);
  PanelDock::Place place = besideThePlant;
  place.isShown = true;
  inspectorDock_ = add("inspector", tr("Inspector"), Qt::Key_F7, place, inspector_);
  actions_->add({.id = "reset_layout",
                 .text = tr("Reset Layout"),
                 .help = tr("Puts all panels back in their places")},
                [this] { resetLayout(); });
}

void MainWindow::addHelpActions() {
  actions_->beginSection(tr("Help"));
  actions_->add({.id = "palette",
                 .text = tr("Find a Command…"),
                 .help = tr("Runs any command by its name"),
                 .icon = "search",
                 .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P)},
                [this] {
                  auto* palette = new CommandPalette(actions_->all(), this);
                  palette->move(mapToGlobal(QPoint((width() - palette->width()) / 2, 64)));
                  palette->show();
                });
  actions_->add({.id = "manual",
                 .text = tr("Manual"),
                 .help = tr("Tells how things are done"),
                 .icon = "info",
                 .keys = QKeySequence(Qt::Key_F1)},
                [this] { (new ManualWindow(":/manual/manual.md", this))->show(); });
  actions_->add({.id = "shortcuts",
                 .text = tr("Shortcuts"),
                 .help = tr("Shows all keys on one sheet"),
                 .icon = "keyboard",
                 .keys = QKeySequence(Qt::Key_Question)},
                [this] { (new ShortcutSheet(*keys_, this))->show(); });
  actions_->add({.id = "about", .text = tr("About Espalier"), .help = tr("What this is")}, [this] {
    QMessageBox::about(this, tr("About Espalier"),
                       tr("<b>Espalier %1</b><br>From a laser scan of a plant to a skeleton an "
                          "expert would sign.")
                           .arg(QCoreApplication::applicationVersion()));
  });
}

} // namespace espalier
