#pragma once

#include "core/evaluate/traits/axis_traits.h"
#include "core/evaluate/traits/branch_angles.h"
#include "core/evaluate/traits/crown.h"
#include "core/evaluate/traits/strahler.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace espalier {

/// What can be counted and measured on one skeleton.
struct Traits {
  std::size_t nodes = 0;
  std::size_t roots = 0;
  std::size_t tips = 0;                             // apices; a root alone is none
  std::size_t branchings = 0;                       // nodes with several children
  std::size_t segments = 0;                         // maximal unbranched chains
  double length = 0;                                // of all edges [L]
  double medianEdge = 0;                            // of the edges that have a length [L]
  Eigen::Vector3d extent = Eigen::Vector3d::Zero(); // sides of the bounding box [L]
  std::vector<std::size_t> axesByOrder;             // order 0 first
  std::vector<double> lengthByOrder; // of these axes, with the edges that attach them [L]
  std::vector<AxisTraits> axes;      // of these orders
  StemTraits stem;
  std::vector<StrahlerOrder>
      strahler; // number 1 first: as many as the Strahler number of the plant
  BranchAngles angles;
  CrownDimensions crown;
};

/// Zero and empty for an empty skeleton. Time and memory O(N log N).
[[nodiscard]] Traits traits(const Skeleton& skeleton);

[[nodiscard]] std::vector<Eigen::Vector3d> tips(const Skeleton& skeleton);       // [L]
[[nodiscard]] std::vector<Eigen::Vector3d> branchings(const Skeleton& skeleton); // [L]

} // namespace espalier
