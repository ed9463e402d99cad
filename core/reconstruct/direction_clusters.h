#pragma once

#include <Eigen/Core>

#include <numbers>
#include <vector>

namespace espalier {

struct DirectionClusterOptions {
  int most = 5;                                    // clusters, >= 1
  int starts = 5;                                  // of the search for each number of them, >= 1
  double mergeAngle = 25 * std::numbers::pi / 180; // [rad] nearer clusters are one
};

/// Groups directions that point much the same way: a mixture of von Mises-Fisher distributions,
/// fitted by expectation and maximization, with as many as the integrated completed likelihood
/// calls for: -2 log L + v log n + 2 H for v parameters and the entropy H of who belongs where.
///
/// Directions that all lie within 30 degrees of each other are one group. Starts are spread over
/// the directions, each cluster as far as can be from those before it. Concentrations are limited
/// as if directions had errors of 4 degrees, so that a few equal ones do not count for more.
///
/// @param directions unit vectors, or zero, which belong to no group
/// @return groups of places in `directions`, the largest first, none of them empty
/// Deterministic. Time O(n most^2 starts), for at most 120 directions evenly out of all; the others
/// go where they fit best.
/// Source: A. Banerjee et al., "Clustering on the unit hypersphere using von Mises-Fisher
/// distributions", JMLR 6, 2005; C. Biernacki et al., IEEE PAMI 22, 2000 (ICL).
[[nodiscard]] std::vector<std::vector<std::size_t>>
directionClusters(const std::vector<Eigen::Vector3d>& directions,
                  const DirectionClusterOptions& options = {});

} // namespace espalier
