#include "app/window/frame/window_log.h"

namespace espalier {

Q_LOGGING_CATEGORY(windowLog, "espalier.window", QtWarningMsg)

} // namespace espalier
