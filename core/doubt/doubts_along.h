#pragma once

#include "core/doubt/doubt.h"
#include "core/skeleton/finding.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// Of each finding, which of the doubts is about the same points: the missing branches lead along
/// most of them, within `near` [L] or twice their radius, and this one along more than the others.
/// None: they do not, or it is no finding of points.
/// pre: points of the findings are in `cloud`. At most 64 points of a finding are looked at, so it
/// takes O(64 edges of missing branches near it).
[[nodiscard]] std::vector<std::optional<std::size_t>>
doubtsAlong(const std::vector<Finding>& findings, const std::vector<Doubt>& doubts,
            const PointCloud& cloud, double near);

} // namespace espalier
