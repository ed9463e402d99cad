#pragma once

#include "core/skeleton/finding.h"

#include <vector>

namespace espalier {

/// What it is worth to look at a finding, in the measure of a doubt.
struct FindingGain {
  double length = 0; // [L] of the wood that it is about, or that is missing
  double wrong = 0;  // how probably that is an error, in [0, 1]
  double gain = 0;   // as that of a doubt: a share of the plant in [0, 1]
};

/// Of each finding. How probably it is an error follows from its kind, as was measured on simulated
/// plants that were reconstructed (espalier_findings --found); of a bare twig, from how many points
/// it has, and from how many others there are, as leaves make many small ones.
/// @param others  of the same plant, which count for that, too, as those that are ignored
/// pre: `skeleton` has the nodes of the findings. O(N + findings)
[[nodiscard]] std::vector<FindingGain> gainsOf(const std::vector<Finding>& findings,
                                               const Skeleton& skeleton,
                                               const std::vector<Finding>& others = {});

/// The nodes whose edges a finding says are wrong: the branch that is attached wrongly, or what has
/// no points. None where wood is missing. pre: `skeleton` has its nodes
[[nodiscard]] std::vector<NodeId> woodOf(const Finding& finding, const Skeleton& skeleton);

} // namespace espalier
