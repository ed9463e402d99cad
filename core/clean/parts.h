#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

enum class KeptParts : std::uint8_t {
  largest, // that of most points
  rooted,  // that of the point nearest to the root
  large    // all that have enough points
};

struct PartOptions {
  KeptParts keep = KeptParts::large;
  Length widestGap = spacings(8); // [L] between points of one part
  int leastPoints = 50;           // of parts that are kept, where all large ones are; >= 1
};

/// For each point whether its part is left out. A part holds the points between which steps of at
/// most the widest gap lead.
///
/// @param points  3 x N [L]
/// @param root    [L], in their frame; none: rooted keeps the largest
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N) per round of joins, see core/graph/components.h.
[[nodiscard]] std::vector<bool> outsideParts(const Eigen::Matrix3Xf& points,
                                             const std::optional<Eigen::Vector3f>& root,
                                             const PartOptions& options,
                                             const Progress& progress = {});

} // namespace espalier
