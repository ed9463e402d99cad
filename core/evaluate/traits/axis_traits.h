#pragma once

#include "core/skeleton/axes.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// Sizes of the axes of one order; means over them.
struct AxisTraits {
  std::size_t count = 0;
  double meanLength = 0;      // along the axis, with the edge that attaches it [L]
  double lengthDeviation = 0; // standard deviation of the same; 0 of a single one [L]
  double medianLength = 0;    // [L]
  double meanChord = 0;       // straight from where it is attached to its apex [L]
  double meanInsertion = 0;   // where it leaves: share of the length of what bears it, in [0, 1];
                              // 0 of roots
  double meanBaseRadius = 0;  // of the first nodes that have one [L]; 0: none has
  double meanTopRadius = 0;   // of the apices that have one [L]
};

/// The axes of each order, order 0 first. Time O(N log N).
[[nodiscard]] std::vector<AxisTraits> axisTraits(const Skeleton& skeleton);

/// The stem, and the stretch of it that bears branches.
struct StemTraits {
  double length = 0;        // [L], along it
  double lowestBranch = 0;  // along it, to where the first branch leaves [L]; 0 of both: none does
  double highestBranch = 0; // to where the last one does [L]
  double baseRadius = 0;    // [L]; 0: it has none
  double topRadius = 0;     // [L]
};

/// Of stemOf(). Time O(N).
[[nodiscard]] StemTraits stemTraits(const Skeleton& skeleton);

/// The axis that begins at the root; of several trees, that of the longest. Empty without nodes.
[[nodiscard]] Axis stemOf(const Skeleton& skeleton);

} // namespace espalier
