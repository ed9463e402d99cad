#pragma once

#include "app/report/report.h"

#include <filesystem>
#include <string>

namespace espalier {

/// Checks that the name of a file says how a report is written.
/// @throws Error which names there may be
void requireReportName(const std::filesystem::path& path);

/// Writes a report as its name says, whole or not at all. Needs a QGuiApplication.
/// @throws Error as requireReportName() and writeAtomically()
void writeReport(const std::filesystem::path& path, const Report& report);

} // namespace espalier
