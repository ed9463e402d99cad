#pragma once

#include "core/align/pair_fit.h"

#include <filesystem>
#include <string>
#include <vector>

namespace espalier {

/// Pairs of targets by the scan that is to be moved, in the order of `moved`.
///
/// A row of the table has the place in the moved scan and that in the fixed one: x, y, z, fixed_x,
/// fixed_y, fixed_z; the first line may name these columns in another order. Where there are
/// several moved scans, a column `scan` says which: the name of its file, or its number from 1.
/// @throws Error with the line of a field that is no number, or of a scan that is not among `moved`
[[nodiscard]] std::vector<std::vector<TargetPair>>
readTargetPairs(const std::filesystem::path& file, const std::vector<std::string>& moved);

} // namespace espalier
