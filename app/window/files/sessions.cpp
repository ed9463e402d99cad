#include "app/window/files/sessions.h"

#include "app/window/files/kept_work.h"
#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/project/project.h"
#include "ui/document/time_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

struct SessionText {
  Q_DECLARE_TR_FUNCTIONS(Sessions)
};

/// A session that was made ready, and its window ended by force before an edit.
void removeUnused(const QString& path) {
  const ProjectLock lock(toPath(path)); // throws if a window has just taken it
  Sessions::remove(path);
}

std::optional<Session> sessionIn(const QString& path) {
  try {
    const Project project = Project::open(toPath(path), Access::readOnly);
    const Imported<History> read = project.history();
    const History& history = read.value;
    if (history.steps.empty() && !hasKeptWork(project)) {
      if (read.notes.empty()) removeUnused(path);
      return std::nullopt;
    }
    const std::optional<ScanReference> scan = project.scan();
    return Session{.path = path,
                   .name = QString::fromStdString(project.document("name")),
                   .scan = scan ? QString::fromStdString(scan->path.string()) : QString(),
                   .file = QString::fromStdString(project.document("file")),
                   .edits = static_cast<int>(history.steps.size()),
                   .last = history.steps.empty()
                               ? QFileInfo(path).lastModified()
                               : QDateTime::fromMSecsSinceEpoch(history.steps.back().time)};
  } catch (const Error&) { // no session, or none any more: a start must not fail on it
    return std::nullopt;
  }
}

QString dayOf(const QDateTime& time, const QDateTime& now) {
  const qint64 days = time.date().daysTo(now.date());
  if (days == 0) return SessionText::tr("today");
  if (days == 1) return SessionText::tr("yesterday");
  return dayText(time.date());
}

} // namespace

Sessions::Sessions(const QSettings& settings)
    : folder_(settings
                  .value("sessions_folder",
                         QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                             "/sessions")
                  .toString()) {}

bool Sessions::contains(const QString& path) const {
  return QFileInfo(path).absoluteDir() == QDir(folder_);
}

QString Sessions::newPath() const {
  QDir().mkpath(folder_);
  const QString time = QDateTime::currentDateTimeUtc().toString("yyyyMMdd-hhmmss");
  QString path;
  for (int i = 0; path.isEmpty() || QFile::exists(path); ++i)
    path = QStringLiteral("%1/%2-%3-%4.espalier")
               .arg(folder_, time)
               .arg(QCoreApplication::applicationPid())
               .arg(i);
  return path;
}

QList<Session> Sessions::waiting() const {
  QList<Session> sessions;
  for (const QFileInfo& file : QDir(folder_).entryInfoList({"*.espalier"}, QDir::Files)) {
    if (ProjectLock::holder(toPath(file.filePath()))) continue;
    if (auto session = sessionIn(file.filePath())) sessions.append(*session);
  }
  std::ranges::sort(sessions, std::ranges::greater(), &Session::last);
  return sessions;
}

void Sessions::remove(const QString& path) {
  for (const char* ending : {"", "-wal", "-shm", ".lock"})
    QFile::remove(path + ending);
}

QString describe(const Session& session, const QDateTime& now) {
  const QString edits = session.edits == 0   ? SessionText::tr("what was decided, no edits")
                        : session.edits == 1 ? SessionText::tr("1 edit")
                                             : SessionText::tr("%1 edits").arg(session.edits);
  const QString source = session.file.isEmpty() ? session.scan : session.file;
  const QString folder = QFileInfo(source).dir().dirName(); // many scans have the same name
  const QString plant = source.isEmpty() || folder.isEmpty()
                            ? session.name
                            : SessionText::tr("%1 in %2").arg(session.name, folder);
  return QStringLiteral("%1, %2, %3 %4")
      .arg(plant, edits, dayOf(session.last, now), clockText(session.last.time()));
}

} // namespace espalier
