#pragma once

#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// All findings that need no scan, in the order of Finding::Kind, and of one kind parents before
/// their children. Nothing is changed.
///
/// A turn is reported between two successor edges. That of a branch from its bearer is reported
/// where it turns back, which is more of a turn: the first edge of a branch leads from the middle
/// of its bearer to its own beginning, and while it ends amid that wood, may go almost anywhere. Of
/// the places where two axes touch, the one where they are deepest in each other is reported
/// (core/skeleton/crossings.h).
/// @param spacing between points of the scan [L]; 0: there is none, or it is not known
/// Time O(n log n) unless much wood is in one place.
[[nodiscard]] std::vector<Finding> check(const Skeleton& skeleton, double spacing = 0,
                                         const CheckOptions& options = {});

} // namespace espalier
