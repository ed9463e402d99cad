#pragma once

#include "core/skeleton/skeleton.h"

#include <array>
#include <cstddef>
#include <vector>

namespace espalier {

struct AngleSummary {
  std::size_t count = 0;
  double mean = 0;      // [rad]
  double deviation = 0; // standard deviation [rad]; 0 of fewer than two
};

/// In which directions branches leave the axes that bear them.
struct BranchAngles {
  std::vector<AngleSummary> byOrder; // of branches of order 1, 2 ...: from the axis, in [0, pi]
  /// From each branch to the next one along the same axis, around the axis, either way: in [0, pi].
  AngleSummary divergence;
  std::array<std::size_t, 6> divergences{}; // how many in each 30 degrees
};

/// Branching angles and phyllotaxy.
///
/// The angle of a branch is that of its first edge to the edge that leads to the node that bears
/// it; the divergence of two that follow each other is that of internodes(). Which way around the
/// axis it goes is left out, since it differs between the axes of a plant. Nodes within an edge
/// change nothing, nor does the frame. Time and memory O(N).
[[nodiscard]] BranchAngles branchAngles(const Skeleton& skeleton);

} // namespace espalier
