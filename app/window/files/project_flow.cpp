#include "app/window/files/project_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/kept_work.h"
#include "app/window/files/load_files.h"
#include "app/window/files/recent_files.h"
#include "core/base/error.h"
#include "core/io/dropped.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "ui/document/length_unit.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/jobs/job_slot.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

QString pathOf(const Project& project) {
  return QString::fromStdString(project.path().string());
}

/// What people call the plant: its file or its scan.
QString nameOf(const PlantDocument& document) {
  const QString path = document.filePath().isEmpty() ? document.scanPath() : document.filePath();
  return path.isEmpty() ? ProjectFlow::tr("a plant") : QFileInfo(path).completeBaseName();
}

bool hasWork(const std::vector<Kept>& beside) {
  return std::ranges::any_of(beside, [](const Kept& kept) {
    return std::ranges::find(keptWork, kept.name) != keptWork.end() && !kept.text().empty();
  });
}

} // namespace

ProjectFlow::ProjectFlow(const Parts& parts)
    : parts_(parts), sessions_(parts.settings), recorder_(parts.document) {
  parts_.document.setAuthor(author());
  connect(&parts_.jobs, &JobSlot::finished, this, &ProjectFlow::finishKeeping);
  connect(&recorder_, &ProjectRecorder::failed, this, &ProjectFlow::reportFailure);
  connect(&recorder_, &ProjectRecorder::projectChanged, this, [this] {
    emit workedOn(recorder_.project() == nullptr ? QString() : pathOf(*recorder_.project()));
  });
  connect(&recorder_, &ProjectRecorder::behindChanged, this, [this] {
    if (isNamed())
      parts_.document.setSaving(recorder_.isBehind() ? PlantDocument::Saving::failing
                                                     : PlantDocument::Saving::asItHappens);
  });
  connect(&parts_.document.undoStack(), &QUndoStack::indexChanged, this,
          &ProjectFlow::startSession);
  connect(&parts_.document, &PlantDocument::titleChanged, this, &ProjectFlow::noteFile);
  connect(&parts_.document, &PlantDocument::skeletonReplaced, this, [this] { versions_.clear(); });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::skeletonReplaced})
    connect(&parts_.document, signal, &prepare_, qOverload<>(&QTimer::start));
  prepare_.setSingleShot(true);
  prepare_.setInterval(500); // [ms], once the plant is on the screen
  connect(&prepare_, &QTimer::timeout, this, &ProjectFlow::prepareSession);
}

void ProjectFlow::endWork() {
  blockSignals(true); // who would show it is going too
  release(parts_.document.isModified());
}

QString ProjectFlow::author() const {
  return parts_.settings.value("author", qEnvironmentVariable("USER")).toString();
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
  const QFileInfo file(path);
  const auto holder = ProjectLock::holder(toPath(path));
  if (!holder && (file.isWritable() || !file.exists())) return load(path, As::itself);
  emit reported({.text = holder ? tr("%1 is open in another window (%2)")
                                      .arg(file.fileName(), QString::fromStdString(*holder))
                                : tr("%1 may only be read").arg(file.fileName()),
                 .isError = true,
                 .actions = {{tr("Open a Copy"), [this, path] { openCopy(path); }},
                             {tr("Open Read-Only"), [this, path] { openReadOnly(path); }}}});
}

void ProjectFlow::openCopy(const QString& path) {
  load(path, As::copy);
}

void ProjectFlow::openReadOnly(const QString& path) {
  load(path, As::readOnly);
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
  QString path = dialog.selectedFiles().front();
  if (const QString ending = QStringLiteral(".espalier");
      !path.endsWith(ending, Qt::CaseInsensitive)) {
    path += ending; // by which projects are known
    if (QFileInfo::exists(path))
      throw Error(tr("%1 is there already: choose that name to replace it")
                      .arg(QFileInfo(path).fileName())
                      .toStdString());
  }
  saveAs(path);
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
  takeIntoNew(*project);
  release(false); // a session's work is in the named one from here on
  leave();
  take(std::move(project));
  writeRest();
  recorder_.flush();
  emit reported({.text = tr("Saved %1: from now on, each edit is saved as it happens")
                             .arg(QFileInfo(path).fileName())});
}

bool ProjectFlow::confirmSaved() {
  recorder_.flush();
  if (!recorder_.isBehind()) {
    emit reported({.text = tr("Everything is saved in %1")
                               .arg(QFileInfo(pathOf(*recorder_.project())).fileName())});
    return true;
  }
  reportFailure(tr("%1 cannot be written: save it elsewhere")
                    .arg(QFileInfo(pathOf(*recorder_.project())).fileName()));
  return false;
}

/// What its history does not hold.
void ProjectFlow::takeIntoNew(Project& project) const {
  project.setScan(scan_);
  for (const PlantVersion& version : versions_)
    project.addVersion(version);
}

Project& ProjectFlow::named() const {
  if (!isNamed())
    throw Error(tr("this plant is in no project yet: save it as one first").toStdString());
  return *recorder_.project();
}

void ProjectFlow::addVersion(const PlantVersion& version) {
  named().addVersion(version);
  versions_.insert(std::ranges::upper_bound(versions_, version.time, {}, &PlantVersion::time),
                   version);
}

void ProjectFlow::removeVersion(const std::string& name) {
  named().removeVersion(name);
  std::erase_if(versions_, [&](const PlantVersion& version) { return version.name == name; });
}

void ProjectFlow::compact() {
  Project& project = named();
  recorder_.flush();
  const QString path = pathOf(*recorder_.project());
  const auto size = [&] { return static_cast<std::uint64_t>(QFileInfo(path).size()); };
  const std::uint64_t before = size();
  project.compact();
  emit reported(
      {.text = tr("%1 is %2 now; it was %3")
                   .arg(QFileInfo(path).fileName(), formatBytes(size()), formatBytes(before))});
}

bool ProjectFlow::holdsMoreThanItsFile() const {
  if (hasWork(beside_)) return true;
  const QString& path = parts_.document.filePath();
  if (path.isEmpty() || parts_.document.undoStack().count() == 0) return false;
  try {
    const Format& format = formatToWrite(toPath(path), Content::structure);
    return !droppedBy(format, parts_.document.skeleton()).empty();
  } catch (const Error&) { // a format that is only read: nothing was saved in it
    return false;
  }
}

void ProjectFlow::leave() {
  if (hasWork(beside_)) prepareSession();
  release(parts_.document.isModified() ? keepsWork() : holdsMoreThanItsFile());
  parts_.document.setSaving(PlantDocument::Saving::byHand);
  parts_.document.setReadOnly({});
  hasFailed_ = false;
}

void ProjectFlow::clear() {
  leave();
  isScanKept_ = false;
  parts_.document.clear();
  scan_.reset();
  for (const Kept& beside : beside_)
    beside.show({});
}

void ProjectFlow::keep(const WindowPart& part) {
  for (const Kept& kept : part.kept()) {
    beside_.push_back(kept);
    recorder_.keep(kept.name, kept.text);
  }
  connect(&part, &WindowPart::keptChanged, this, [this] {
    if (recorder_.project() == nullptr) prepare_.start();
    recorder_.noteChange();
  });
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
  const PlantDocument& document = parts_.document;
  const bool isAny = document.isEmpty() && !isWithoutPositions(document.structure());
  const auto found = std::ranges::find_if(
      waiting, [&](const Session& session) { return isAny || isOfThePlant(session); });
  if (found == waiting.end()) return offerToGoBack({});
  const QString path = found->path;
  const QString text = isAny ? tr("Continue with %1") : tr("Work on this plant was kept: %1");
  emit reported({.text = text.arg(describe(*found, QDateTime::currentDateTime())),
                 .actions = {{tr("Continue"), [this, path] { emit chosen(path); }},
                             {tr("Discard"), [this, path] {
                                Sessions::remove(path);
                                offerSessions();
                              }}}});
}

void ProjectFlow::offerToGoBack(const std::optional<Notice>& beside) {
  Notice notice = beside.value_or(Notice());
  const QList<Session> waiting = sessions_.waiting();
  const auto left = std::ranges::find(waiting, std::exchange(left_, {}), &Session::path);
  if (left != waiting.end()) {
    if (beside) notice.text += '\n';
    notice.text += tr("Your work is kept: %1").arg(describe(*left, QDateTime::currentDateTime()));
    notice.actions.push_back(
        {tr("Go Back to It"), [this, path = left->path] { emit chosen(path); }});
  }
  if (!notice.text.isEmpty()) emit reported(notice);
}

bool ProjectFlow::isOfThePlant(const Session& session) const {
  const auto isSame = [](const QString& path, const QString& other) {
    return !path.isEmpty() && !other.isEmpty() && QFileInfo(path) == QFileInfo(other);
  };
  return isSame(parts_.document.scanPath(), session.scan) ||
         isSame(parts_.document.filePath(), session.file);
}

void ProjectFlow::load(const QString& path, As as) {
  parts_.jobs.requireIdle();
  parts_.jobs.start(
      tr("Reading %1").arg(QFileInfo(path).fileName()),
      [path, as](const Progress& progress) {
        return loadProject(path, as == As::itself ? Access::readWrite : Access::readOnly, progress);
      },
      [this, as](LoadedProject loaded) {
        const auto kept = std::make_shared<LoadedProject>(std::move(loaded));
        parts_.jobs.afterwards([this, as, kept] { gate_([&] { show(std::move(*kept), as); }); });
      });
}

void ProjectFlow::show(LoadedProject loaded, As as) {
  PlantDocument& document = parts_.document;
  leave();
  const bool isCopy = as == As::copy || loaded.isDamaged;
  const QString path = pathOf(*loaded.project);
  const bool isSession = sessions_.contains(path);
  const bool isScanMissing = loaded.scan == nullptr && !loaded.scanPath.isEmpty();
  isLoading_ = true;
  document.clear();
  document.setUnit(loaded.unit);
  if (loaded.scan) document.setScan(std::move(loaded.scan), loaded.scanPath);
  document.openHistory(std::move(loaded.history), loaded.frame, isSession ? loaded.file : QString(),
                       loaded.contracted);
  isLoading_ = false;
  versions_ = std::move(loaded.versions);
  scan_ = loaded.scanReference;
  reading_ = loaded.reading;
  isScanKept_ = loaded.isScanKept;
  emit opened();
  showBeside(*loaded.project,
             loaded.notes); // once the scan is there, which gives options their range
  if (as == As::readOnly) {
    document.markSaved(path);
    document.setReadOnly(tr("%1 is open read-only: save it as another project to edit that")
                             .arg(QFileInfo(path).fileName()));
  } else if (isCopy)
    startSession();
  else
    take(std::move(loaded.project));
  if (isScanMissing)
    emit reported(
        {.text = tr("The scan %1 is not where it was").arg(QFileInfo(loaded.scanPath).fileName()),
         .isError = true,
         .actions = {{tr("Find Scan…"), [this] { askForScan(); }}}});
  if (!loaded.notes.isEmpty()) reportFailure(loaded.notes.join('\n'));
  const bool isAlone = !isScanMissing && loaded.notes.isEmpty(); // or it would hide these
  if (isAlone) offerToGoBack(as == As::itself && !isSession ? authorNotice() : std::nullopt);
}

/// Who made the last step, if none is by the one that further steps are recorded of; else empty.
QString ProjectFlow::otherAuthor() const {
  const QString own = author();
  QString last;
  for (int i = 0; i < parts_.document.undoStack().index(); ++i) {
    const QString by = QString::fromStdString(parts_.document.step(i).author);
    if (by.isEmpty()) continue;
    if (by == own) return {};
    last = by;
  }
  return last;
}

/// Further steps are recorded under the name that was used last in this program, whoever's the
/// project is. None: there is nothing to ask.
std::optional<Notice> ProjectFlow::authorNotice() {
  const QString other = otherAuthor();
  if (other.isEmpty()) return std::nullopt;
  const QString own = author();
  return Notice{
      .text =
          own.isEmpty()
              ? tr("This project is by %1: your steps will be recorded without a name").arg(other)
              : tr("This project is by %1: your steps will be recorded as by %2").arg(other, own),
      .actions = {{tr("Go On as %1").arg(other), [this, other] { emit authorChosen(other); }}}};
}

void ProjectFlow::showBeside(const Project& project, QStringList& notes) {
  for (const Kept& beside : beside_) {
    try {
      beside.show(project.document(beside.name));
    } catch (const Error& error) {
      notes.append(shownText(error));
      beside.show({});
    }
  }
}

void ProjectFlow::take(std::unique_ptr<Project> project) {
  recorder_.start(std::move(project));
  if (!isNamed()) return;
  const QString path = pathOf(*recorder_.project());
  parts_.document.markSaved(path);
  parts_.document.setSaving(PlantDocument::Saving::asItHappens);
  parts_.recent.add(path);
  parts_.settings.setValue(folderKey, QFileInfo(path).absolutePath());
}

void ProjectFlow::release(bool isSessionKept) {
  const bool isSession = recorder_.project() != nullptr && !isNamed();
  const std::unique_ptr<Project> project = recorder_.stop();
  if (!isSession) return;
  if (isSessionKept)
    left_ = pathOf(*project);
  else
    Sessions::remove(pathOf(*project));
}

void ProjectFlow::startSession() {
  if (isLoading_ || hasFailed_ || parts_.document.isReadOnly() || recorder_.project() != nullptr ||
      parts_.document.undoStack().count() == 0)
    return;
  hasFailed_ = !guarded([this] { makeSession(); });
}

void ProjectFlow::makeSession() {
  auto project = makeProject(parts_.document, toPath(sessions_.newPath()));
  takeIntoNew(*project);
  project->setDocument("name", nameOf(parts_.document).toStdString());
  project->setDocument("file", parts_.document.filePath().toStdString());
  recorder_.start(std::move(project));
  writeRest();
}

void ProjectFlow::prepareSession() {
  if (isLoading_ || hasFailed_ || recorder_.project() != nullptr || parts_.document.isEmpty() ||
      parts_.document.isReadOnly() || parts_.document.undoStack().count() > 0)
    return;
  if (hasWork(beside_)) {
    hasFailed_ = !guarded([this] { makeSession(); });
    return;
  }
  try {
    makeSession();
  } catch (const Error&) { // who only looks need not know; the first edit reports it
  }
}

void ProjectFlow::noteFile() {
  Project* project = recorder_.project();
  if (project == nullptr || isNamed() || recorder_.isBehind()) return;
  const std::string file = parts_.document.filePath().toStdString();
  const std::string name = nameOf(parts_.document).toStdString();
  guarded([&] {
    if (project->document("file") != file) project->setDocument("file", file);
    if (project->document("name") != name) project->setDocument("name", name);
  });
}

// What follows an edit or the end of a job: an error is reported, and takes nothing back.
bool ProjectFlow::guarded(const std::function<void()>& act) {
  try {
    act();
    return true;
  } catch (const Error& error) {
    reportFailure(shownText(error));
    return false;
  }
}

void ProjectFlow::reportFailure(const QString& message) {
  emit reported({.text = message, .isError = true, .actions = {{tr("Save Elsewhere…"), [this] {
                                                                  saveAs();
                                                                }}}});
}

} // namespace espalier
