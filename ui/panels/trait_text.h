#pragma once

#include "core/evaluate/trait_rows.h"
#include "ui/document/length_unit.h"

#include <QString>

namespace espalier {

/// A trait as people read it: "12.4 mm", "0.214", "61.3°", "17".
[[nodiscard]] QString textOf(const TraitRow& row, LengthUnit unit);

} // namespace espalier
