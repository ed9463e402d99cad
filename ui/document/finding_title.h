#pragma once

#include "core/skeleton/finding.h"

#include <QString>

namespace espalier {

/// "Sharp turns"
[[nodiscard]] QString titleOf(Finding::Kind kind);
/// "Sharp turn"
[[nodiscard]] QString nameOfOne(Finding::Kind kind);

} // namespace espalier
