#pragma once

#include "app/report/report.h"

#include <QByteArray>

namespace espalier {

/// A report as one HTML file that fetches nothing: pictures and plots are inside it. It fits a
/// phone and A4, is light or dark as the reader's system is, and well-formed as XML. The same
/// report gives the same bytes.
[[nodiscard]] QByteArray htmlOf(const Report& report);

} // namespace espalier
