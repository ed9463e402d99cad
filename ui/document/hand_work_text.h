#pragma once

#include "core/project/corrections.h"

#include <QString>

namespace espalier {

class PlantDocument;

/// Of the steps that are done.
[[nodiscard]] HandWork handWork(const PlantDocument& document);
[[nodiscard]] MadeByHand madeByHand(const PlantDocument& document); // likewise

/// "1 h 12 min", "12 min", "under a minute"
[[nodiscard]] QString formatWorkTime(std::int64_t milliseconds);

/// "4 edits; nodes: 2 added, 1 moved", kinds that did not occur left out; "none"
[[nodiscard]] QString describe(const Corrections& corrections);

} // namespace espalier
