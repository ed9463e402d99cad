#pragma once

#include "core/evaluate/comparison.h"

namespace espalier {

/// `tolerance` if it is above 0, else usualTolerance() [L].
[[nodiscard]] double toleranceOr(double tolerance, const Skeleton& reference);

/// The options of a comparison at some tolerance: the usual distances, and this one.
/// @param tolerance [L]; 0 = usualTolerance()
[[nodiscard]] ComparisonOptions withTolerance(ComparisonOptions options, const Skeleton& reference,
                                              double tolerance);

} // namespace espalier
