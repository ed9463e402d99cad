#pragma once

#include <QString>

namespace espalier {

/// The style sheet of a report; colors of plots are taken from plotColors().
[[nodiscard]] QString htmlStyle();

} // namespace espalier
