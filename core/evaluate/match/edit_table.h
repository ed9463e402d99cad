#pragma once

#include "core/evaluate/match/edit_comparison.h"

#include <string>
#include <vector>

namespace espalier {

/// The mapping behind an edit distance, as a table with a heading: a row for each match, then for
/// each part of the result that is removed, and for each of the reference that is inserted.
///
///   edit                          matched, merged, split, removed or inserted
///   result, reference             ids of the nodes of the parts, from the foot up; may be empty
///   result_x ... reference_z [L]  where the topmost of these nodes is, in the frame of its file
///   cost                          of a match, [1] or [L] by the cost of the distance
///
/// pre: both are the skeletons that were compared, moved or not
[[nodiscard]] std::vector<std::vector<std::string>>
editTable(const EditComparison& edit, const Skeleton& result, const Skeleton& reference);

} // namespace espalier
