#pragma once

#include "core/radius/measured_radius.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// Radii by measurements and a model, by id.
struct FusedRadii {
  std::vector<double> radii;      // [L]
  std::vector<double> shares;     // of measurements in the radius, in [0, 1]
  std::vector<double> deviations; // standard ones of the logarithms, if those that went in and the
                                  // steps along the tree are true and independent: far too small
};

/// From points, of the node or others on its axis, if they have a share of over three quarters in
/// the radius; from what the node carries if they have under a quarter.
[[nodiscard]] RadiusSource sourceOf(double share);

struct FusionOptions {
  double modelSpread = 0.2; // standard deviation of the logarithm of radii about the model, > 0
  double axisStep = 0.05;   // of how much that differs from a node to the next of its axis, > 0
  double branchStep = 0.3;  // and from an axis to a branch, > 0
};

/// Radii by measurements and a model, each as far as it can be trusted.
///
/// The logarithms x of the radii have the least sum of squares of: x less the measured one, in its
/// deviation; x less that of the model, in modelSpread; the change of this difference along each
/// edge, in axisStep or branchStep; and, where a node would be thicker than its parent, by how
/// much, in 2 %. What is left of that is then cut off. So a good measurement counts for the nodes
/// around it, thin wood follows the model from the last measured place on, and nothing widens to
/// the tip.
///
/// @param measured  by id
/// @param model     by id [L]; where it is 0, the least radius that is known stands in for it, and
///                  all are 0 if none is
/// Deterministic. Time O(n): the tree is eliminated from its tips, a few times over.
/// Source: D. Rose, "Triangulated graphs and the elimination process", J. Math. Anal. Appl. 32,
/// 1970, for trees.
[[nodiscard]] FusedRadii fusedRadii(const Skeleton& skeleton,
                                    const std::vector<MeasuredRadius>& measured,
                                    const std::vector<double>& model,
                                    const FusionOptions& options = {});

/// `radii` [L] by id, none greater than its parent's on an axis, or than `branchShare` of it on a
/// branch, which is in (0, 1]. From the root up. Time O(n).
/// Source: PlantScan3D's "Filter radius"; TreeQSM holds branches to 0.95.
[[nodiscard]] std::vector<double> limitedRadii(const Skeleton& skeleton, std::vector<double> radii,
                                               double branchShare = 1);

} // namespace espalier
