#pragma once

#include "app/report/pdf_pages.h"
#include "app/report/report.h"

#include <vector>

namespace espalier {

/// Adds a table: whole on a page if it fits on one.
void addTable(PdfPages& pages, const ReportTable& table);

/// As wide as the widest cell; the widest columns of words get narrower where that is too wide, and
/// none of numbers or hashes.
[[nodiscard]] std::vector<double> columnWidths(const PdfPages& pages, const ReportTable& table);

/// The height that it takes with its caption, or that of a page if it has to be cut.
[[nodiscard]] double heightOf(const PdfPages& pages, const ReportTable& table);

} // namespace espalier
