#include "app/cli/command_line.h"
#include "app/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QSettings>

namespace {

/// Opens the editor on the files given; returns when its window is closed.
int runEditor(int argc, char** argv) {
  const QApplication application(argc, argv);
  QApplication::setApplicationName("Espalier");
  QApplication::setOrganizationName("Espalier");
  QApplication::setApplicationVersion(ESPALIER_VERSION);
  QSettings settings;
  espalier::MainWindow window(settings);
  window.show();
  const QStringList files = QApplication::arguments().mid(1);
  if (!files.isEmpty()) window.open(files);
  return QApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
  if (espalier::isForCommandLine(argc, argv)) return espalier::runCommandLine(argc, argv);
  return runEditor(argc, argv);
}
