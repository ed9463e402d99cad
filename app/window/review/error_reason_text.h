#pragma once

#include "core/decide/error_evidence.h"
#include "ui/document/length_unit.h"

#include <QString>

namespace espalier {

/// Why a piece of the plant is risky, as a phrase for each of the two strongest reasons: "no point
/// is near 62 % of it; other wood is 3.1 mm from it". Empty: nothing stands out.
/// @param spacing  that the evidence counts in [L]
[[nodiscard]] QString textOfReasons(const ErrorEvidence& evidence, double spacing, LengthUnit unit);

} // namespace espalier
