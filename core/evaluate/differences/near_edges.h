#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// Which edges of a skeleton are near another: half of their length lies within `tolerance` [L].
///
/// By id, of the node at the upper end; a root counts by its place. Stretches that leave what is
/// near and are shorter than the tolerance count as near; stretches that are near for less than
/// three tolerances, below and above something that is not, do not.
/// pre: the other is not empty, tolerance > 0
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + length / tolerance) log N).
[[nodiscard]] std::vector<bool> nearEdges(const Skeleton& skeleton, const Skeleton& other,
                                          double tolerance, const Progress& progress = {});

/// Stretches of edges that all are, or all are not, marked in `flags`, cut out of a skeleton: each
/// is connected along its edges, parents before their children, in the order of the first nodes.
/// Only those whose flag is `value`. Twigs that only leave the same node are stretches of their
/// own.
[[nodiscard]] std::vector<std::vector<NodeId>>
stretches(const Skeleton& skeleton, const std::vector<bool>& flags, bool value);

} // namespace espalier
