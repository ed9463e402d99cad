#pragma once

#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <cstdint>

namespace espalier::test {

/// A root at the origin and nodes straight above it, `step` apart; all successors, radius 0.1.
[[nodiscard]] Skeleton stick(int nodes, double step = 1);

inline constexpr NodeId forkRoot{0};
inline constexpr NodeId forkTop{1};

/// A root at the origin, forkTop one above it, and on that `shoots` single nodes, evenly around at
/// 45 degrees; the first is a successor, the others branch.
[[nodiscard]] Skeleton fork(int shoots);

/// How many nodes have no children.
[[nodiscard]] std::ptrdiff_t countTips(const Skeleton& skeleton);

/// A forest of `nodes` nodes (one to three trees) with arbitrary positions, radii and edges.
[[nodiscard]] Skeleton randomPlant(int nodes, std::uint64_t seed);

/// A trunk 0-1-2-3 along z, on 1 the branch 4-5, on 4 the twig 6, on 2 the branch 7.
[[nodiscard]] Skeleton walkedTree();

} // namespace espalier::test
