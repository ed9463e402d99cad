#pragma once

#include "app/report/report.h"

#include <QByteArray>

namespace espalier {

/// A report as PDF on A4, with its title and page numbers. No picture, row or short table is cut:
/// what does not fit goes to the next page, and a table longer than a page repeats its head.
/// Needs a QGuiApplication, for fonts.
[[nodiscard]] QByteArray pdfOf(const Report& report);

/// How many pages that has. Cost: as pdfOf().
[[nodiscard]] int pdfPagesOf(const Report& report);

} // namespace espalier
