#pragma once

#include "core/evaluate/authors_comparison.h"

namespace espalier {

// Readings of the authors' comparison that do not let errors hide.

/// Share of the length of both that is matched at a cost of at most `distance` [L]: the authors'
/// geometric index without matches of segments that are far from each other.
[[nodiscard]] double geometricIndexWithin(const AuthorsComparison& comparison, double distance);

/// Share of all segments of the reference, matched or not, whose match is conserved: the authors'
/// structural index is over the matched ones alone.
[[nodiscard]] double structuralIndexOfAll(const AuthorsComparison& comparison);

} // namespace espalier
