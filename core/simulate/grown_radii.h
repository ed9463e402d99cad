#pragma once

#include "core/skeleton/skeleton.h"

#include <cstdint>

namespace espalier {

struct GrownRadiusOptions {
  double baseRadius = 0;  // [L] of the thickest root, >= apexRadius
  double apexRadius = 0;  // [L] of each apex, > 0
  double spread = 0;      // standard deviation of the logarithm between axes, in [0, 1]
  double flare = 0;       // how much wider a trunk is where it leaves the ground, >= 0
  std::uint64_t seed = 0; // of the spread
};

/// The plant with radii that follow from what each node carries.
///
/// r = apexRadius w^k, where w = 1 at an apex and grows by all that joins: the sum over the
/// children plus a part for the length of wood on the path, so that axes become thinner between
/// branchings too. The exponent k follows from the two radii given. With even node spacing this is
/// the node-count pipe model that fits published expert structures to rounding. On it, each axis is
/// by chance thicker or thinner, as real ones are, but nowhere thicker than the node that bears it.
///
/// @throws Error if the radii are not positive and ordered
/// Deterministic. Time and memory O(N).
/// Source: K. Shinozaki et al., "A quantitative analysis of plant form: the pipe model theory",
/// Jpn. J. Ecol. 14, 1964. Differs: length counts besides apices.
[[nodiscard]] Skeleton withGrownRadii(Skeleton plant, const GrownRadiusOptions& options);

} // namespace espalier
