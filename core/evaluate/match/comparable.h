#pragma once

#include "core/skeleton/skeleton.h"

#include <string_view>

namespace espalier {

/// Checks that a skeleton can be compared: it has nodes, finite positions, and some length.
///
/// @param role what the user calls it in a message: "the plant", "the reference"
/// @throws Error that names what is missing, and the node where there is one
void requireComparable(const Skeleton& skeleton, std::string_view role);

[[nodiscard]] double totalLength(const Skeleton& skeleton); // of all edges [L]

/// Median length of the edges that have one [L]; 0 if none has.
[[nodiscard]] double medianEdgeLength(const Skeleton& skeleton);

} // namespace espalier
