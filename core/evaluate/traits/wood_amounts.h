#pragma once

#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// How much wood there is.
struct WoodAmount {
  std::size_t edges = 0;
  double length = 0; // [L]
  double area = 0;   // of the bark [L^2]
  double volume = 0; // [L^3]
};

/// The wood of a plant, as a whole and in classes.
struct WoodAmounts {
  WoodAmount whole;
  std::vector<WoodAmount> byOrder;  // order 0 first
  std::vector<WoodAmount> byRadius; // by the limits asked for, and above the last
};

/// Limits of radius classes, ascending [L]: the greatest radius of a skeleton halved five times
/// down to half of it, so that six classes come of them; empty if no node has a radius.
[[nodiscard]] std::vector<double> radiusLimits(const Skeleton& skeleton);

/// Length, area and volume by order and by radius.
///
/// Each edge is its frustum. It counts for the order of its upper node and for the class of its
/// mean radius; a limit belongs to the class below it. Time and memory O(N).
[[nodiscard]] WoodAmounts woodAmounts(const Skeleton& skeleton,
                                      const std::vector<double>& radiusLimits);

} // namespace espalier
