#pragma once

#include "core/graph/find_root.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// The axis that a plant seems to stand along: the one at whose low end its points stand close
/// together, as those of a foot do.
///
/// At each low end are looked at the two slabs of a twelfth of the extent: how far their points lie
/// about the middle of each, by the median, against all points about theirs. A foot is where both
/// are under a fifth. One of x or y counts only where z has none that is as much as 2.5 times as
/// wide, and where each slab holds 1.5 % of the points: a twig that stands out at a side is as
/// narrow, but holds fewer. (The feet of simulated trees hold 2 % and more.) Nor does one along
/// which the plant is less than two thirds as long as along z: most scanners stand upright, and few
/// plants are that much wider than high.
///
/// @param points  a sample of a scan [L], from all parts of it
/// @return none if no foot is seen, as where the ground was scanned too
/// Deterministic. Time O(N).
[[nodiscard]] std::optional<UpAxis> likelyUp(const std::vector<Eigen::Vector3d>& points);

} // namespace espalier
