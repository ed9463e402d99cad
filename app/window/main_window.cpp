#include "app/window/main_window.h"

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
#include "app/window/icon.h"
#include "app/window/judge_flow.h"
#include "app/window/key_hints.h"
#include "app/window/node_table_flow.h"
#include "app/window/panel_dock.h"
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
#include "app/window/view_sync.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_line.h"
#include "ui/panels/vertex_page.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QCloseEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QMenu>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolTip>

#include <utility>

/// Icons, manual and style live in a static library, which the linker else leaves out. Not in a
/// namespace, as the macro asks.
static void useResources() {
  Q_INIT_RESOURCE(icons);
  Q_INIT_RESOURCE(manual);
  Q_INIT_RESOURCE(style);
}

namespace espalier {
namespace {

QStringList localFiles(const QMimeData& data) {
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths.append(url.toLocalFile());
  return paths;
}

} // namespace

MainWindow::MainWindow(QSettings& settings, QWidget* parent)
    : QMainWindow(parent), settings_(settings), recent_(std::make_unique<RecentFiles>(settings)),
      actions_(std::make_unique<ActionSet>(*this)), status_(new StatusLine),
      pipeline_(new PipelinePanel(document_)), inspector_(new InspectorPanel(document_)) {
  useResources();
  setObjectName("main_window");
  setWindowIcon(programIcon());
  setAcceptDrops(true);
  setMinimumSize(960, 600);
  constexpr QSize frame(16, 48); // what the desktop puts around a window, about
  resize(QSize(1280, 800).boundedTo(screen()->availableSize() - frame));
  makeCenter();
  statusBar()->addPermanentWidget(status_, 1);
  statusBar()->setSizeGripEnabled(false);

  sync_ = std::make_unique<ViewSync>(document_, *view_);
  reconstruct_ = std::make_unique<ReconstructFlow>(document_, jobs_, nullptr);
  projects_ = std::make_unique<ProjectFlow>(
      ProjectFlow::Parts{document_, jobs_, *recent_, settings_, *this});
  files_ = std::make_unique<FileFlow>(
      FileFlow::Parts{document_, jobs_, *projects_, *recent_, settings_, *this});
  addActions();
  fillMenus();
  fillToolBar();
  connectJobs();
  connectFiles();
  connectProjects();
  connectDocument();
  connectReview();
  connectFindings();
  connectAtHand();
  connectEvaluation();
  connectPreview();
  theme_->start();
  restoreGeometry(settings_.value("window/geometry").toByteArray());
  restoreState(settings_.value("window/state").toByteArray());
  refreshEmptiness();
  projects_->offerSessions();
}

MainWindow::~MainWindow() {
  hide();                                 // or its last events reach panels whose plant is gone
  document_.undoStack().disconnect(this); // it clears itself when the parts are gone
}

void MainWindow::open(const QStringList& paths) {
  actions_->guarded(
      [&] {
        files_->open(paths);
        return true;
      },
      Refusal::inBanner);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const bool mayClose =
      actions_->guarded([this] { return files_->mayDiscard(); }, Refusal::inBanner);
  if (!mayClose) {
    event->ignore();
    return;
  }
  jobs_.cancel();
  projects_->leave();
  settings_.setValue("window/geometry", saveGeometry());
  settings_.setValue("window/state", saveState());
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!localFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const QStringList paths = localFiles(*event->mimeData());
  if (!reference_->takesDropped(paths)) open(paths);
}

void MainWindow::makeCenter() {
  auto* page = new QWidget(this);
  auto* layers = new QGridLayout(page);
  layers->setContentsMargins(0, 0, 0, 0);
  layers->setSpacing(0);
  center_ = new QStackedWidget(page);
  start_ = new StartPage(center_);
  views_ = new QSplitter(center_);
  views_->setChildrenCollapsible(false);
  views_->setHandleWidth(3);
  view_ = new PlantView(views_);
  start_->setIcon(programIcon());
  center_->addWidget(start_);
  center_->addWidget(views_);
  vertices_ = new VertexPage(center_);
  center_->addWidget(vertices_);
  // The banner lies over the view, which keeps its size.
  banner_ = new MessageBanner(center_);
  banner_->setCover([this](const QRect& part) {
    int covered = 0;
    for (const PlantView* view : {view_, twoViews_ ? twoViews_->second() : nullptr})
      if (view != nullptr && view->isVisible())
        covered += view->coveredBy(part.translated(-view->mapTo(center_, QPoint())));
    return covered;
  });
  layers->addWidget(center_, 0, 0); // bars lie below
  setCentralWidget(page);
}

void MainWindow::closePlant() {
  if (jobs_.isRunning()) jobs_.cancel();
  if (!files_->mayDiscard()) return;
  projects_->clear();
  banner_->hide();
  projects_->offerSessions();
  refreshEmptiness();
}

void MainWindow::tellStep(int index) {
  if (banner_->leavesByItself()) banner_->hide(); // it told of the step before
  const QUndoStack& stack = document_.undoStack();
  const int before = std::exchange(step_, index);
  if (editing_->isBusy() || projects_->isLoading()) return; // a drag tells what it does itself
  if (index == before - 1 && index < stack.count())
    status_->showNote(tr("Undone: %1").arg(stack.text(index)));
  else if (index == before + 1)
    status_->showNote(index < stack.count() ? tr("Redone: %1").arg(stack.text(index - 1))
                                            : stack.text(index - 1));
}

void MainWindow::refreshDocks() {
  const bool hasPlant = center_->currentWidget() == views_; // panels that do not apply are absent
  pipelineDock_->setPlantShown(hasPlant);
  inspectorDock_->setPlantShown(hasPlant);
  review_->dock().setPlantShown(hasPlant);
  shown_->setAvailable(hasPlant);
  findings_->dock().setPlantShown(hasPlant);
  explained_->setPlantShown(hasPlant);
  states_->setPlantShown(hasPlant);
  history_->dock().setPlantShown(hasPlant);
  nodeTable_->dock().setPlantShown(hasPlant);
  evaluation_->setPlantShown(hasPlant);
  judge_->dock().setPlantShown(hasPlant);
  sweep_->dock().setPlantShown(hasPlant);
}

void MainWindow::refreshTitle() {
  (*actions_)["compact_project"]->setEnabled(projects_->isNamed());
  (*actions_)["keep_scan"]->setEnabled(projects_->isNamed() && document_.scan() != nullptr);
  (*actions_)["keep_scan"]->setChecked(projects_->isScanKept());
  const QString path = document_.filePath().isEmpty() ? document_.scanPath() : document_.filePath();
  setWindowFilePath(path);
  vertices_->setFile(QFileInfo(path).fileName());
  setWindowTitle(path.isEmpty() ? QStringLiteral("Espalier")
                                : QFileInfo(path).fileName() +
                                      (document_.isReadOnly() ? tr(" (read-only)") : QString()) +
                                      "[*] – Espalier");
  setWindowModified(!path.isEmpty() && document_.isModified());
}

void MainWindow::refreshCounts() {
  QStringList parts;
  if (document_.scan() != nullptr) {
    const auto points = std::size_t(document_.scan()->cloud()->size());
    parts.append(points == 1 ? tr("1 pt") : tr("%1 pts").arg(formatCount(points)));
  }
  if (const std::size_t nodes = document_.skeleton().size(); nodes > 0)
    parts.append(nodes == 1 ? tr("1 node") : tr("%1 nodes").arg(formatCount(nodes)));
  if (units_->marks() > 0) parts.append(tr("%1 marked").arg(formatCount(units_->marks())));
  if (const std::size_t hidden = shown_->hidden().size(); hidden > 0)
    parts.append(tr("%1 hidden").arg(formatCount(hidden)));
  if (!document_.leftOut().isEmpty())
    parts.append(tr("%1 set aside").arg(formatCount(document_.leftOut().size())));
  const auto& frame = document_.structure().frame;
  if (frame && center_->currentWidget() == vertices_) {
    const std::size_t vertices = frame->mtg.vertices.size();
    parts.append(vertices == 1 ? tr("1 vertex") : tr("%1 vertices").arg(formatCount(vertices)));
  }
  if (document_.unit() != LengthUnit::unknown) parts.append(symbol(document_.unit()));
  status_->setCounts(parts.join(QStringLiteral(" · ")));
}

void MainWindow::refreshHint() {
  QString hint = editing_->hint();
  if (document_.isEmpty()) // while a file is read, that is all there is to say
    hint = jobs_.isRunning() ? QString() : tr("Open a scan, or drop one here");
  if (center_->currentWidget() == vertices_)
    hint = withKeys(tr("No positions, so no view   {export_structure} write as MTG or OPF   "
                       "{open} open another file"),
                    *actions_);
  if (const QString radius = radius_->hint(); !radius.isEmpty()) hint = radius;
  if (preview_ && preview_->shown() && preview_->isOther() && !editing_->isPending())
    hint = withKeys(tr("Preview   {reconstruct} make it the skeleton   {leave} drop it   "
                       "{keep_as_a} keep as A"),
                    *actions_);
  if (units_->marks() > 0)
    hint += "   " + withKeys(tr("{mark_unit_start} mark unit start"), *actions_);
  status_->setHint(hint);
}

void MainWindow::refreshEmptiness() {
  const bool isShapeless = isWithoutPositions(document_.structure());
  const bool isEmpty = document_.isEmpty() && !document_.undoStack().canUndo();
  const bool showsVertices = isEmpty && isShapeless;
  vertices_->show(showsVertices ? document_.structure().frame : nullptr,
                  (*actions_)["export_structure"]->shortcut().toString(QKeySequence::NativeText));
  center_->setCurrentWidget(showsVertices ? vertices_
                            : isEmpty     ? static_cast<QWidget*>(start_)
                                          : views_);
  const bool canRun = document_.scan() != nullptr && !jobs_.isRunning();
  pipeline_->setRunnable(canRun);
  (*actions_)["reconstruct"]->setEnabled(canRun);
  for (const char* id : {"save", "save_as", "export_structure"})
    (*actions_)[id]->setEnabled(isShapeless || !document_.skeleton().isEmpty());
  (*actions_)["save_project_as"]->setEnabled(isShapeless || !document_.isEmpty());
  refreshDocks();
  refreshTitle();
  refreshCounts();
  refreshHint();
}

void MainWindow::reconstruct(const Step* last) {
  sweep_->stop();
  preview_->stop(); // what it has computed is at hand
  reconstruct_->start(pipeline_->options(), last);
}

void MainWindow::leave() {
  if (editing_->isPending() || !preview_->drop()) editing_->escape();
}

void MainWindow::undoStep() {
  if (editing_->isPending() || !endsPreview(document_.undoStack().index() - 1)) editing_->undo();
}

void MainWindow::redoStep() {
  if (editing_->isPending() || !endsPreview(document_.undoStack().index())) editing_->redo();
}

/// A step of a plant that is behind a preview drops that first: one sees what is undone.
bool MainWindow::endsPreview(int step) {
  const bool isThere = step >= 0 && step < document_.undoStack().count();
  return isThere && document_.isHeld() && !document_.step(step).delta.isEmpty() && preview_->drop();
}

void MainWindow::resetLayout() {
  pipelineDock_->resetLayout();
  inspectorDock_->resetLayout();
  review_->dock().resetLayout();
  findings_->dock().resetLayout();
  shown_->dock().resetLayout();
  history_->dock().resetLayout();
  nodeTable_->dock().resetLayout();
  evaluation_->resetLayout();
  judge_->dock().resetLayout();
  sweep_->dock().resetLayout();
  refreshDocks();
}

void MainWindow::showRefusal(const QString& reason, Refusal where) {
  if (where == Refusal::inBanner) {
    banner_->showError(reason);
    refusal_ = banner_->text();
    return;
  }
  constexpr int reading = 6000; // ms
  QWidget* field = where == Refusal::atField ? units_->field() : nullptr;
  if (field != nullptr)
    QToolTip::showText(field->mapToGlobal(field->rect().bottomLeft()), reason, field, {}, reading);
  else
    QToolTip::showText(QCursor::pos() + QPoint(8, 8), reason, views_, views_->rect(), reading);
  status_->showNote(reason);
}

void MainWindow::showContextMenu(const QPoint& globalPosition) {
  QMenu menu(this);
  points_->fillContextMenu(menu);
  editing_->fillContextMenu(menu);
  if (editing_->nodeUnder()) {
    menu.addSeparator();
    hulls_->fillMenu(menu);
  }
  shown_->fillContextMenu(menu);
  menu.exec(globalPosition);
}

} // namespace espalier
