#include "app/log/run_log.h"

#include "app/about/libraries.h"
#include "app/about/version.h"
#include "app/log/crash_handler.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QLoggingCategory>
#include <QSysInfo>

#include <algorithm>
#include <atomic>
#include <fcntl.h>
#include <unistd.h>

namespace espalier {
namespace {

constexpr int keptRuns = 20;
constexpr qint64 longest = 10'000'000; // [bytes] of a log; what comes behind is left out

std::atomic<int> openLog = -1;   // messages come from any thread
std::atomic<qint64> written = 0; // or left out
QtMessageHandler usual = nullptr;

void writeLine(const QString& text) {
  const QByteArray line = text.toUtf8() + '\n';
  const int log = openLog;
  if (log < 0 || written.fetch_add(line.size()) + line.size() > longest) return;
  // A full disk costs the log alone.
  (void)!::write(log, line.constData(), static_cast<std::size_t>(line.size()));
}

/// May be called by any thread: a line is one write.
void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  writeLine(QDateTime::currentDateTime().toString(Qt::ISODateWithMs) + ' ' +
            (type == QtInfoMsg || type == QtDebugMsg ? QStringLiteral("info")
                                                     : QStringLiteral("warning")) +
            ' ' + QString(text).replace('\n', QLatin1String(" | ")));
  if (type != QtInfoMsg && type != QtDebugMsg && usual != nullptr) usual(type, context, text);
}

void writeHead() {
  writeLine("Espalier " + QString::fromStdString(programVersion()));
  writeLine(QSysInfo::prettyProductName() + ", " + QSysInfo::kernelVersion() + ", " +
            QSysInfo::currentCpuArchitecture());
  QStringList names;
  for (const Library& library : libraries())
    names.append(QString::fromStdString(library.name + ' ' + library.version));
  writeLine(names.join(QStringLiteral(", ")));
}

/// The logs of a folder, the newest first: their names begin with the time.
QStringList logsIn(const QString& folder) {
  return QDir(folder).entryList({"*.log"}, QDir::Files, QDir::Name | QDir::Reversed);
}

} // namespace

RunLog::RunLog(const QString& folder) {
  const QDir place(folder);
  if (!place.mkpath(".")) return;
  const QStringList before = logsIn(folder);
  for (qsizetype i = keptRuns - 1; i < before.size(); ++i)
    QFile::remove(place.filePath(before[i]));
  const QString name = QDateTime::currentDateTimeUtc().toString("yyyyMMdd-hhmmss") + '-' +
                       QString::number(QCoreApplication::applicationPid()) + ".log";
  descriptor_ = ::open(QFile::encodeName(place.filePath(name)).constData(),
                       O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (descriptor_ < 0) return;
  openLog = descriptor_;
  written = 0;
  writeHead();
  QLoggingCategory::setFilterRules("espalier.*=true");
  usual = qInstallMessageHandler(onMessage);
}

RunLog::~RunLog() {
  if (descriptor_ < 0) return;
  qInstallMessageHandler(usual);
  writeLine("ended");
  openLog = -1;
  ::close(descriptor_);
}

QString RunLog::usualFolder() {
  const QString state = qEnvironmentVariable("XDG_STATE_HOME");
  return (QDir::isAbsolutePath(state) ? state : QDir::homePath() + "/.local/state") + "/espalier";
}

std::optional<Crash> takeCrash(const QString& folder) {
  const QDir place(folder);
  for (const QString& name : logsIn(folder)) {
    if (name.endsWith(".taken.log")) continue;
    QFile file(place.filePath(name));
    if (!file.open(QIODevice::ReadOnly)) continue;
    constexpr qint64 end = 1'000'000; // a crash is what comes last, with its frames
    file.seek(std::max<qint64>(0, file.size() - end));
    const QByteArray text = file.readAll();
    const qsizetype at = text.lastIndexOf(QByteArray("\n") + crashLine);
    if (at < 0) continue;
    const qsizetype begin =
        at + 1 + static_cast<qsizetype>(std::char_traits<char>::length(crashLine));
    const QByteArray project = text.mid(begin, text.indexOf('\n', begin) - begin);
    const QString taken = place.filePath(name.chopped(4) + ".taken.log");
    if (!QFile::rename(file.fileName(), taken)) continue; // it would be shown at each start
    return Crash{.log = taken, .project = QFile::decodeName(project)};
  }
  return std::nullopt;
}

} // namespace espalier
