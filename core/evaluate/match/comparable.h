#pragma once

#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <string>

namespace espalier {

/// Which of the two that are compared a message is about.
enum class ComparedAs : std::uint8_t { plant, reference };

/// Checks that a skeleton can be compared: it has nodes, finite positions, and some length.
///
/// @param name  of its file or version
/// @throws ShownError that names what is missing, and the node where there is one
void requireComparable(const Skeleton& skeleton, ComparedAs as);
void requireComparable(const Skeleton& skeleton, const std::string& name);

[[nodiscard]] double totalLength(const Skeleton& skeleton); // of all edges [L]

/// Median length of the edges that have one [L]; 0 if none has.
[[nodiscard]] double medianEdgeLength(const Skeleton& skeleton);

} // namespace espalier
