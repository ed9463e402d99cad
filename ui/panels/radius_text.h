#pragma once

#include "core/skeleton/skeleton.h"
#include "ui/document/length_unit.h"

#include <QString>

namespace espalier {

/// "measured"; empty: not known
[[nodiscard]] QString nameOf(RadiusSource source);

/// Where a radius is from and where the true one lies: "corrected, 2.1 to 3.4 mm"; empty if nothing
/// is known.
[[nodiscard]] QString originText(const Node& node, LengthUnit unit);

} // namespace espalier
