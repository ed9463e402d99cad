#pragma once

#include <QLoggingCategory>

namespace espalier {

/// What is done and shown in the window, for the log of a run (app/log); else it is dropped.
Q_DECLARE_LOGGING_CATEGORY(windowLog)

} // namespace espalier
