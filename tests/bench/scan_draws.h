#pragma once

#include "core/base/counted_random.h"
#include "core/skeleton/skeleton.h"

#include <cmath>
#include <cstddef>

namespace espalier {

// What simulated scans of any kind are drawn by.

[[nodiscard]] inline double between(CountedRandom& random, double least, double most) {
  return least + (most - least) * random.uniform();
}

[[nodiscard]] inline double evenlyInLog(CountedRandom& random, double least, double most) {
  return std::exp(between(random, std::log(least), std::log(most)));
}

[[nodiscard]] inline double lengthOf(const Skeleton& plant) { // [L]
  double length = 0;
  for (const NodeId id : plant.ids())
    if (const auto parent = plant[id].parent)
      length += (plant[id].position - plant[*parent].position).norm();
  return length;
}

/// Chains without branches.
[[nodiscard]] inline std::size_t segmentsOf(const Skeleton& plant) {
  std::size_t ends = 0;
  for (const NodeId id : plant.ids())
    ends += plant.children(id).size() != 1;
  return ends;
}

} // namespace espalier
