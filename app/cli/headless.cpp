#include "app/cli/headless.h"

namespace espalier {

Headless::Headless() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR"))
    qputenv("XDG_RUNTIME_DIR", folder_.path().toLocal8Bit());
  application_ = std::make_unique<QGuiApplication>(argc_, argv_.data());
}

} // namespace espalier
