#include "app/window/main_window.h"

#include "app/window/align/registration_flow.h"
#include "app/window/files/recent_files.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/digit_keys.h"
#include "app/window/frame/icon.h"
#include "app/window/frame/key_hints.h"
#include "app/window/frame/menu_keys.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/frame/panel_keys.h"
#include "app/window/frame/view_sync.h"
#include "app/window/frame/window_log.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "ui/document/time_text.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_line.h"
#include "ui/panels/tour_hint.h"
#include "ui/panels/vertex_page.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QGridLayout>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolTip>

#include <algorithm>
#include <iterator>

/// Icons and style live in a static library, which the linker else leaves out. Not in a
/// namespace, as the macro asks.
static void useResources() {
  Q_INIT_RESOURCE(icons);
  Q_INIT_RESOURCE(license);
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
      actions_(std::make_unique<ActionSet>(*this)), status_(new StatusLine) {
  useResources();
  setObjectName("main_window");
  setWindowIcon(programIcon());
  setAcceptDrops(true);
  // Knobs stay in reach while what they do is judged below the view.
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  constexpr QSize frame(16, 48); // what the desktop puts around a window, about
  const QSize room = screen()->availableSize() - frame; // little, where it is scaled up
  setMinimumSize(QSize(960, 600).boundedTo(room));
  resize(QSize(1280, 800).boundedTo(room));
  makeCenter();
  statusBar()->addPermanentWidget(status_, 1);
  statusBar()->setSizeGripEnabled(false);
  sync_ = std::make_unique<ViewSync>(document_, *view_);

  makeParts();
  new DigitKeys(*actions_, this);
  new MenuKeys(this);
  fillMenus();
  fillToolBar();
  connectJobs();
  connectMessages();
  connectParts();
  connectLog();
  restoreGeometry(settings_.value("window/geometry").toByteArray());
  restoreState(settings_.value("window/state").toByteArray());
  refreshEmptiness();
  for (const auto& part : parts_)
    part->beginWork();
}

MainWindow::~MainWindow() {
  hide(); // or its last events reach panels whose plant is gone
  for (QDockWidget* dock : findChildren<QDockWidget*>())
    dock->hide();                         // those that are windows of their own stay otherwise
  document_.undoStack().disconnect(this); // it clears itself when the parts are gone
}

bool MainWindow::focusNextPrevChild(bool isNext) {
  return giveKeysOn(*this, isNext);
}

void MainWindow::open(const QStringList& paths) {
  emit openRequested(paths);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const auto mayClose = [this] { // files come first in the list: they let go of the plant
    return std::all_of(std::make_reverse_iterator(parts_.end()),
                       std::make_reverse_iterator(parts_.begin()),
                       [](const auto& part) { return part->mayClose(); });
  };
  if (!actions_->guarded(mayClose, Refusal::inBanner)) {
    event->ignore();
    return;
  }
  settings_.setValue("window/geometry", saveGeometry());
  settings_.setValue("window/state", saveState());
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!localFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  emit dropped(localFiles(*event->mimeData()));
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
    int covered = start_->covered(part.translated(-start_->pos()));
    if (const auto* hint = findChild<TourHint*>(); hint != nullptr && hint->isVisible()) {
      const QRect over(center_->mapFromGlobal(hint->mapToGlobal(QPoint())), hint->size());
      const QRect shared = part & over;
      covered += shared.width() * shared.height();
    }
    for (const PlantView* view :
         views_->findChildren<PlantView*>(QString(), Qt::FindDirectChildrenOnly))
      if (view->isVisible())
        covered += view->coveredBy(part.translated(-view->mapTo(center_, QPoint())));
    return covered;
  });
  layers->addWidget(center_, 0, 0); // bars lie below
  setCentralWidget(page);
}

void MainWindow::connectParts() {
  for (const auto& each : parts_) {
    const WindowPart* part = each.get();
    connect(part, &WindowPart::noted, status_, &StatusLine::showNote);
    connect(part, &WindowPart::failed, banner_,
            [this](const QString& message) { banner_->showError(message); });
    connect(part, &WindowPart::reported, this, &MainWindow::showNotice);
    connect(part, &WindowPart::outdated, banner_, &QWidget::hide);
    connect(part, &WindowPart::hintChanged, this, &MainWindow::refreshHint);
    connect(part, &WindowPart::countChanged, this, &MainWindow::refreshCounts);
  }
}

void MainWindow::connectJobs() {
  connect(&jobs_, &JobSlot::started, this, [this] {
    status_->showJob(jobs_.name());
    refreshEnabled();
  });
  connect(&jobs_, &JobSlot::progressed, status_, &StatusLine::showProgress);
  connect(&jobs_, &JobSlot::failed, this,
          [this](const QString& message) { banner_->showError(message); });
  connect(&jobs_, &JobSlot::finished, this, [this] {
    status_->hideJob();
    refreshEnabled();
    if (jobs_.isCanceled()) status_->showNote(tr("Canceled: nothing has changed"));
    refreshEmptiness();
  });
  connect(status_, &StatusLine::cancelRequested, &jobs_, &JobSlot::cancel);
}

void MainWindow::connectMessages() {
  for (auto signal : {&PlantDocument::titleChanged, &PlantDocument::scanChanged})
    connect(&document_, signal, this, &MainWindow::refreshTitle);
  for (auto signal :
       {&PlantDocument::scanChanged, &PlantDocument::skeletonReplaced, &PlantDocument::unitChanged})
    connect(&document_, signal, this, &MainWindow::refreshCounts);
  connect(&document_, &PlantDocument::skeletonEdited, this, &MainWindow::refreshCounts);
  connect(&document_, &PlantDocument::leftOutChanged, this, &MainWindow::refreshCounts);
  const auto endRefusal = [this] { // why the last action was not done is history
    if (banner_->isError() && banner_->text() == refusal_) banner_->hide();
  };
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, [this, endRefusal] {
    if (banner_->leavesByItself()) banner_->hide(); // it was about the step before
    endRefusal();                                   // an edit by the mouse is no action
  });
  connect(actions_.get(), &ActionSet::refused, this, &MainWindow::showRefusal);
  connect(actions_.get(), &ActionSet::acted, this, endRefusal);
  connect(start_, &StartPage::openRequested, (*actions_)["open"], &QAction::trigger);
  connect(start_, &StartPage::fileChosen, this, [this](const QString& path) { open({path}); });
  connect(recent_.get(), &RecentFiles::changed, this,
          [this] { start_->setRecentFiles(recent_->paths()); });
  start_->setRecentFiles(recent_->paths());
}

void MainWindow::connectLog() {
  for (const QAction* action : actions_->all())
    connect(action, &QAction::triggered, this,
            [id = action->objectName()] { qCInfo(windowLog).noquote() << "command" << id; });
  connect(&jobs_, &JobSlot::started, this,
          [this] { qCInfo(windowLog).noquote() << "job" << jobs_.name(); });
  connect(&jobs_, &JobSlot::finished, this, [] { qCInfo(windowLog) << "job ended"; });
  connect(banner_, &MessageBanner::shown, this,
          [](const QString& text) { qCInfo(windowLog).noquote() << "shown" << text; });
  connect(this, &MainWindow::openRequested, this, [](const QStringList& paths) {
    qCInfo(windowLog).noquote() << "open" << paths.join(QStringLiteral(", "));
  });
  connect(this, &MainWindow::workedOn, this,
          [](const QString& project) { qCInfo(windowLog).noquote() << "project" << project; });
}

void MainWindow::showCrash(const QString& project, const QString& log) {
  const bool isThere = !project.isEmpty() && QFileInfo::exists(project);
  Notice notice = {.text = tr("Espalier crashed on %1. What happened is in %2")
                               .arg(momentText(QFileInfo(log).lastModified()), log),
                   .isError = true};
  if (isThere) {
    notice.text +=
        tr("; what was done until then is saved in %1").arg(QFileInfo(project).fileName());
    notice.actions.push_back({tr("Go On With It"), [this, project] { open({project}); }});
  }
  showNotice(notice);
}

void MainWindow::showNotice(const Notice& notice) {
  if (notice.isStep)
    return banner_->showResult(notice.text, tr("Undo"), [this] { (*actions_)["undo"]->trigger(); });
  MessageBanner::Actions actions;
  for (const BannerAction& action : notice.actions)
    actions.push_back({action.text, [this, act = action.act] { guarded(act); }});
  if (notice.isError)
    banner_->showError(notice.text, actions);
  else if (actions.empty())
    banner_->showResult(notice.text);
  else
    banner_->showOffer(notice.text, actions);
}

void MainWindow::refreshDocks() {
  const bool hasPlant = center_->currentWidget() == views_; // panels that do not apply are absent
  for (const auto& part : parts_) {
    for (PanelDock* dock : part->docks())
      dock->setPlantShown(hasPlant);
    part->setPlantShown(hasPlant);
  }
}

/// What a job will replace is not to be edited meanwhile, nor the plant while a scan is registered.
void MainWindow::refreshEnabled() {
  const WindowPart& registration = parts_.get<RegistrationFlow>();
  const bool isRegistering = parts_.get<RegistrationFlow>().isActive();
  for (const auto& part : parts_)
    part->setEnabled(!jobs_.isBusy() && (!isRegistering || part.get() == &registration));
}

void MainWindow::refreshTitle() {
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
  QStringList counts;
  if (document_.scan() != nullptr) {
    const std::size_t points =
        std::size_t(document_.scan()->cloud()->size()) - document_.scan()->leftOut().size();
    counts.append(points == 1 ? tr("1 pt") : tr("%1 pts").arg(formatCount(points)));
  }
  if (const std::size_t nodes = document_.skeleton().size(); nodes > 0)
    counts.append(nodes == 1 ? tr("1 node") : tr("%1 nodes").arg(formatCount(nodes)));
  for (const auto& part : parts_)
    if (const QString count = part->count(); !count.isEmpty()) counts.append(count);
  if (!document_.leftOut().isEmpty())
    counts.append(tr("%1 set aside").arg(formatCount(document_.leftOut().size())));
  const auto& frame = document_.structure().frame;
  if (frame && center_->currentWidget() == vertices_) {
    const std::size_t vertices = frame->mtg.vertices.size();
    counts.append(vertices == 1 ? tr("1 vertex") : tr("%1 vertices").arg(formatCount(vertices)));
  }
  if (document_.unit() != LengthUnit::unknown) counts.append(symbol(document_.unit()));
  status_->setCounts(counts.join(QStringLiteral(" · ")));
}

void MainWindow::refreshHint() {
  const QString between = QStringLiteral("   ");
  QString hint;
  QStringList further;
  for (const auto& part : parts_) {
    if (const QString its = part->hint(); !its.isEmpty()) hint = its;
    if (const QString its = part->furtherHint(); !its.isEmpty()) further += its.split(between);
  }
  if (document_.isEmpty()) // while a file is read, that is all there is to say
    hint = jobs_.isBusy() ? QString() : tr("Open a scan, or drop one here");
  if (center_->currentWidget() == vertices_)
    hint = withKeys(tr("No positions, so no view   {export_structure} write as MTG or OPF   "
                       "{open} open another file"),
                    *actions_);
  const auto isOfLeave = // which is named once, with what it does first
      [key = (*actions_)["leave"]->shortcut().toString(QKeySequence::NativeText) +
             ' '](const QString& each) { return each.startsWith(key); };
  if (std::ranges::any_of(hint.split(between), isOfLeave)) further.removeIf(isOfLeave);
  further.prepend(hint);
  status_->setHint(further.join(between));
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
  refreshDocks();
  refreshTitle();
  refreshCounts();
  refreshHint();
}

void MainWindow::addLayoutAction() {
  actions_->add({.id = "reset_layout",
                 .text = tr("Reset Layout"),
                 .help = tr("Puts all panels back in their places"),
                 .menu = "panels/layout"},
                [this] { resetLayout(); });
}

void MainWindow::resetLayout() {
  for (const auto& part : parts_)
    for (PanelDock* dock : part->docks())
      dock->resetLayout();
  refreshDocks();
}

void MainWindow::showRefusal(const QString& reason, Refusal where) {
  if (where == Refusal::inBanner) {
    banner_->showError(reason);
    refusal_ = banner_->text();
    return;
  }
  constexpr int reading = 6000; // ms
  QWidget* field = where == Refusal::atField ? actions_->field() : nullptr;
  if (field != nullptr)
    QToolTip::showText(field->mapToGlobal(field->rect().bottomLeft()), reason, field, {}, reading);
  else
    QToolTip::showText(QCursor::pos() + QPoint(8, 8), reason, views_, views_->rect(), reading);
  status_->showNote(reason);
}

void MainWindow::guarded(const std::function<void()>& act) {
  actions_->guarded(
      [&] {
        act();
        return true;
      },
      Refusal::inBanner);
}

} // namespace espalier
