#include "app/about/version.h"
#include "app/cli/command_line.h"
#include "app/log/crash_handler.h"
#include "app/log/run_log.h"
#include "app/window/frame/language.h"
#include "app/window/main_window.h"
#include "ui/jobs/job_threads.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSettings>

#include <clocale>
#include <cstdlib>
#include <iostream>

namespace {

/// Whether there is something to open a window on. Without, Qt would abort.
bool hasDisplay() {
  return !qEnvironmentVariableIsEmpty("DISPLAY") ||
         !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
         !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

/// Says in one line what keeps Qt from starting, where it would abort: most often a display that
/// DISPLAY names but nobody serves.
void endOnFatal(QtMsgType type, const QMessageLogContext&, const QString&) {
  if (type == QtFatalMsg) {
    const QString display =
        qEnvironmentVariable("DISPLAY", qEnvironmentVariable("WAYLAND_DISPLAY"));
    std::cerr
        << "espalier: the editor cannot open the display " << qPrintable(display)
        << ": check the variable DISPLAY, or use a subcommand, which needs none (see espalier "
           "--help)\n";
    std::_Exit(1);
  }
}

/// The first of these that looks like an option, and names no file; null: none does.
QString unknownOptionAmong(const QStringList& files) {
  for (const QString& file : files)
    if (file.startsWith('-') && !QFile::exists(file)) return file;
  return {};
}

/// Opens the editor on the files given; returns when its window is closed.
int runEditor(int argc, char** argv) {
  const QtMessageHandler usual = qInstallMessageHandler(endOnFatal);
  const QApplication application(argc, argv);
  qInstallMessageHandler(usual);
  const QStringList files = QApplication::arguments().mid(1); // without options of Qt
  if (const QString unknown = unknownOptionAmong(files); !unknown.isNull()) {
    std::cerr << "espalier: the editor takes files, and no option " << qPrintable(unknown)
              << ": leave it out, or name a subcommand before it (see espalier --help)\n";
    return 2;
  }
  std::setlocale(LC_NUMERIC, "C"); // Qt has set the system's, by which libraries write 0,5
  QApplication::setApplicationName("Espalier");
  QApplication::setOrganizationName("Espalier");
  QApplication::setApplicationVersion(QString::fromStdString(espalier::programVersion()));
  QGuiApplication::setDesktopFileName("org.espalier.Espalier"); // whose icon Wayland shows
  const QString logs = espalier::RunLog::usualFolder();
  const espalier::RunLog log(logs);
  espalier::reportCrashes(log.descriptor());
  espalier::setJobThreadStart(&espalier::reportCrashesOfThread);
  QSettings settings;
  espalier::useLanguage(settings);
  espalier::MainWindow window(settings);
  QObject::connect(&window, &espalier::MainWindow::workedOn, [](const QString& project) {
    espalier::setWorkedOn(QFile::encodeName(project).toStdString());
  });
  window.show();
  if (!files.isEmpty()) window.open(files);
  if (const auto crash = espalier::takeCrash(logs)) window.showCrash(crash->project, crash->log);
  return QApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
  espalier::reportCrashes(-1);
  if (espalier::isForCommandLine(argc, argv)) return espalier::runCommandLine(argc, argv);
  if (!hasDisplay()) {
    std::cerr
        << "espalier: there is no display for the editor: log in on one, or use a subcommand, "
           "which needs none (see espalier --help)\n";
    return 1;
  }
  return runEditor(argc, argv);
}
