#pragma once

#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <optional>
#include <string>

namespace espalier {

/// How thick a stem is at some height, or why that is not known.
struct StemDiameter {
  std::optional<double> value; // [L]
  std::string missing;         // empty if there is a value; shown by shownText()
};

/// What the user calls a plant.
enum class StemOf : std::uint8_t { plant, reference };

/// Of stemOf(), where it first rises to this height. It changes evenly along an edge.
///
/// @param z  [L], in the frame of the plant; up is z
/// Time O(N).
[[nodiscard]] StemDiameter stemDiameterAt(const Skeleton& plant, double z, StemOf of);

} // namespace espalier
