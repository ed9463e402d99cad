#pragma once

#include "core/skeleton/skeleton.h"

#include <optional>

namespace espalier {

struct PreparationOptions {
  double spacing = 0;    // [L] between nodes at most, >= 0; 0 = a third of the median edge
  int smoothing = 1;     // passes that take kinks out of the axes, in [0, 100]
  double baseRadius = 0; // [L] where radii are missing, >= 0; 0 = height / 100
  double apexRadius = 0; // [L] where radii are missing, >= 0; 0 = height / 1500
  std::optional<double> apexExtension; // [L] added to each apex, >= 0; none: half the median edge
};

/// A structure made by hand or by a program, made fit to be scanned and to be the truth of the
/// scan.
///
/// Such structures have coarse nodes, angular axes and now and then no radii. Kinks are smoothed;
/// each axis becomes a smooth curve through its nodes, with further nodes on it. Missing radii (0)
/// are those of withGrownRadii, scaled by the median to those that are known. Branchings, edge
/// types and the number of unbranched chains stay as they are.
///
/// @throws Error if a position or radius is not finite, or an option is out of its range
/// Deterministic. Time and memory O(N) for N nodes of the result.
/// Source: cubic Hermite curves with the tangents of a parabola through three nodes, by chord
/// length (Catmull-Rom for uneven nodes).
[[nodiscard]] Skeleton preparedPlant(const Skeleton& structure,
                                     const PreparationOptions& options = {});

} // namespace espalier
