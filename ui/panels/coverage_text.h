#pragma once

#include "core/skeleton/review_coverage.h"
#include "ui/document/length_unit.h"

#include <QString>

namespace espalier {

/// "99.9": percent in a state. Rounded down, so that it is 100 only where all nodes are.
[[nodiscard]] QString percentText(const ReviewCoverage& seen, ReviewState state, int decimals);

/// How much is in a state: its length, or its nodes if they are too few for their length to count.
[[nodiscard]] QString amountText(const ReviewCoverage& seen, ReviewState state, LengthUnit unit);

/// "1 node"
[[nodiscard]] QString nodesText(std::size_t nodes);

} // namespace espalier
