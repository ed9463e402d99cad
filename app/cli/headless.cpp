#include "app/cli/headless.h"

#include <QLocale>

#include <clocale>

namespace espalier {

Headless::Headless() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR"))
    qputenv("XDG_RUNTIME_DIR", folder_.path().toLocal8Bit());
  application_ = std::make_unique<QGuiApplication>(argc_, argv_.data());
  // Qt has set what the system has: files and reports are the same everywhere.
  std::setlocale(LC_ALL, "C");
  QLocale::setDefault(QLocale::c());
}

} // namespace espalier
