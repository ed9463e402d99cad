#include "app/window/project_flow.h"

#include "app/window/load_files.h"
#include "app/window/recent_files.h"
#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_runner.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>

#include <utility>

namespace espalier {
namespace {

const QString folderKey = QStringLiteral("last_folder");

QString pathOf(const Project& project) {
  return QString::fromStdString(project.path().string());
}

/// What people call the plant: its file or its scan.
QString nameOf(const PlantDocument& document) {
  const QString path = document.filePath().isEmpty() ? document.scanPath() : document.filePath();
  return path.isEmpty() ? ProjectFlow::tr("a plant") : QFileInfo(path).completeBaseName();
}

} // namespace

ProjectFlow::ProjectFlow(const Parts& parts)
    : parts_(parts), sessions_(parts.settings), recorder_(parts.document) {
  parts_.document.setAuthor(
      parts_.settings.value("author", qEnvironmentVariable("USER")).toString());
  connect(&recorder_, &ProjectRecorder::failed, this, &ProjectFlow::tellFailure);
  connect(&parts_.document.undoStack(), &QUndoStack::indexChanged, this,
          &ProjectFlow::startSession);
  connect(&parts_.document, &PlantDocument::titleChanged, this, &ProjectFlow::noteFile);
}

ProjectFlow::~ProjectFlow() {
  blockSignals(true); // who would show it is going too
  release(parts_.document.isModified());
}

bool ProjectFlow::isNamed() const {
  return recorder_.project() != nullptr && !sessions_.contains(pathOf(*recorder_.project()));
}

bool ProjectFlow::keepsWork() {
  recorder_.flush();
  if (recorder_.project() == nullptr || recorder_.isBehind()) return false;
  return isNamed() || parts_.document.filePath().isEmpty();
}

void ProjectFlow::open(const QString& path) {
  const auto holder = ProjectLock::holder(toPath(path));
  if (!holder) return load(path, Access::readWrite);
  emit told({.text = tr("%1 is open in another window (%2)")
                         .arg(QFileInfo(path).fileName(), QString::fromStdString(*holder)),
             .isError = true,
             .actions = {{tr("Open a Copy"), [this, path] { openCopy(path); }}}});
}

void ProjectFlow::openCopy(const QString& path) {
  load(path, Access::readOnly);
}

bool ProjectFlow::saveAs() {
  QFileDialog dialog(&parts_.window, tr("Save the project"), {},
                     tr("Espalier projects (*.espalier)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("espalier");
  const QString scan = parts_.document.scanPath();
  dialog.setDirectory(scan.isEmpty() ? parts_.settings.value(folderKey).toString()
                                     : QFileInfo(scan).path());
  dialog.selectFile(nameOf(parts_.document) + ".espalier");
  if (dialog.exec() != QDialog::Accepted) return isNamed();
  saveAs(dialog.selectedFiles().front());
  return true;
}

void ProjectFlow::saveAs(const QString& path) {
  if (isNamed() && !recorder_.isBehind() &&
      QFileInfo(path) == QFileInfo(pathOf(*recorder_.project()))) {
    confirmSaved();
    return;
  }
  if (isNamed() && QFileInfo(path).absoluteFilePath() == pathOf(*recorder_.project()))
    recorder_.stop(); // its file is gone or cannot be written: it is made anew
  std::unique_ptr<Project> project = makeProject(parts_.document, toPath(path));
  project->setScan(scan_);
  leave();
  take(std::move(project));
  emit told({.text = tr("Saved %1: from now on, each edit is saved as it happens")
                         .arg(QFileInfo(path).fileName())});
}

bool ProjectFlow::confirmSaved() {
  recorder_.flush();
  if (!recorder_.isBehind()) {
    emit told({.text = tr("Everything is saved")});
    return true;
  }
  tellFailure(tr("%1 cannot be written: save it elsewhere")
                  .arg(QFileInfo(pathOf(*recorder_.project())).fileName()));
  return false;
}

void ProjectFlow::compact() {
  if (!isNamed())
    throw Error(tr("this plant is in no project yet: save it as one first").toStdString());
  recorder_.flush();
  const QString path = pathOf(*recorder_.project());
  const qint64 before = QFileInfo(path).size();
  recorder_.project()->compact();
  const QLocale locale;
  emit told({.text = tr("%1 is %2 now; it was %3")
                         .arg(QFileInfo(path).fileName(),
                              locale.formattedDataSize(QFileInfo(path).size()),
                              locale.formattedDataSize(before))});
}

void ProjectFlow::leave() {
  release(parts_.document.isModified() && keepsWork());
  parts_.document.setAlwaysSaved(false);
  hasFailed_ = false;
}

void ProjectFlow::setScanReference(const std::optional<ScanReference>& scan) {
  scan_ = scan;
  guarded([this] {
    if (recorder_.project() != nullptr) recorder_.project()->setScan(scan_);
  });
}

void ProjectFlow::offerSessions() {
  const QList<Session> waiting = sessions_.waiting();
  emit sessionsChanged();
  if (waiting.isEmpty()) return;
  const QString path = waiting.front().path;
  emit told(
      {.text = tr("Continue with %1").arg(describe(waiting.front(), QDateTime::currentDateTime())),
       .actions = {{tr("Continue"), [this, path] { emit chosen(path); }},
                   {tr("Discard"), [this, path] {
                      Sessions::remove(path);
                      offerSessions();
                    }}}});
}

void ProjectFlow::load(const QString& path, Access access) {
  if (parts_.jobs.isRunning())
    throw Error(
        tr("%1 is still running: wait for it, or cancel it").arg(parts_.jobs.name()).toStdString());
  parts_.jobs.start(
      tr("Reading %1").arg(QFileInfo(path).fileName()),
      [path, access](const Progress& progress) { return loadProject(path, access, progress); },
      [this, access](LoadedProject loaded) {
        const auto kept = std::make_shared<LoadedProject>(std::move(loaded));
        parts_.jobs.afterwards(
            [this, access, kept] { gate_([&] { show(std::move(*kept), access); }); });
      });
}

void ProjectFlow::show(LoadedProject loaded, Access access) {
  PlantDocument& document = parts_.document;
  leave();
  const bool isCopy = access == Access::readOnly || loaded.isDamaged;
  const bool isSession = sessions_.contains(pathOf(*loaded.project));
  const bool isScanMissing = loaded.scan == nullptr && !loaded.scanPath.isEmpty();
  isLoading_ = true;
  document.clear();
  document.setUnit(loaded.unit);
  if (loaded.scan) document.setScan(std::move(loaded.scan), loaded.scanPath);
  if (loaded.contracted) document.setContracted(loaded.contracted);
  document.openHistory({std::move(loaded.history.skeleton), loaded.frame},
                       std::move(loaded.history.steps), loaded.history.position,
                       isSession ? loaded.file : QString(), loaded.contractedStep);
  isLoading_ = false;
  scan_ = loaded.scanReference;
  if (isCopy)
    startSession();
  else
    take(std::move(loaded.project));
  emit opened();
  if (isScanMissing)
    emit told(
        {.text = tr("The scan %1 is not where it was").arg(QFileInfo(loaded.scanPath).fileName()),
         .isError = true,
         .actions = {{tr("Find Scan…"), [this] { askForScan(); }}}});
  if (!loaded.notes.isEmpty()) tellFailure(loaded.notes.join('\n'));
}

void ProjectFlow::take(std::unique_ptr<Project> project) {
  recorder_.start(std::move(project));
  if (!isNamed()) return;
  const QString path = pathOf(*recorder_.project());
  parts_.document.markSaved(path);
  parts_.document.setAlwaysSaved(true);
  parts_.recent.add(path);
  parts_.settings.setValue(folderKey, QFileInfo(path).absolutePath());
}

void ProjectFlow::release(bool isSessionKept) {
  const bool isSession = recorder_.project() != nullptr && !isNamed();
  const std::unique_ptr<Project> project = recorder_.stop();
  if (isSession && !isSessionKept) Sessions::remove(pathOf(*project));
}

void ProjectFlow::startSession() {
  if (isLoading_ || hasFailed_ || recorder_.project() != nullptr ||
      parts_.document.undoStack().count() == 0)
    return;
  hasFailed_ = !guarded([this] {
    auto project = makeProject(parts_.document, toPath(sessions_.newPath()));
    project->setScan(scan_);
    project->setDocument("name", nameOf(parts_.document).toStdString());
    project->setDocument("file", parts_.document.filePath().toStdString());
    recorder_.start(std::move(project));
  });
}

void ProjectFlow::noteFile() {
  Project* project = recorder_.project();
  if (project == nullptr || isNamed() || recorder_.isBehind()) return;
  const std::string file = parts_.document.filePath().toStdString();
  guarded([&] {
    if (project->document("file") != file) project->setDocument("file", file);
  });
}

// What follows an edit or the end of a job: an error is told, and takes nothing back.
bool ProjectFlow::guarded(const std::function<void()>& act) {
  try {
    act();
    return true;
  } catch (const Error& error) {
    tellFailure(QString::fromUtf8(error.what()));
    return false;
  }
}

void ProjectFlow::askForScan() {
  const QString path =
      QFileDialog::getOpenFileName(&parts_.window, tr("Find the scan of this project"),
                                   parts_.settings.value(folderKey).toString());
  if (path.isEmpty() || !scan_) return;
  parts_.jobs.start(
      tr("Reading %1").arg(QFileInfo(path).fileName()),
      [path, scan = *scan_](const Progress& progress) { return loadScan(path, scan, progress); },
      [this, path](std::unique_ptr<const Scan> scan) {
        ScanReference found = *scan_;
        found.path = toPath(QFileInfo(path).absoluteFilePath());
        parts_.document.setScan(std::move(scan), path);
        setScanReference(found);
        emit opened();
      });
}

void ProjectFlow::tellFailure(const QString& message) {
  emit told({.text = message, .isError = true, .actions = {{tr("Save Elsewhere…"), [this] {
                                                              saveAs();
                                                            }}}});
}

} // namespace espalier
