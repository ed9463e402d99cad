#pragma once

#include "app/report/report.h"

#include <QString>

namespace espalier {

/// A plot as an SVG element to stand inside HTML, which sets the fonts.
[[nodiscard]] QString svgOf(const ReportPlot& plot);

} // namespace espalier
