#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is a MAT file of MATLAB 5 or later.
[[nodiscard]] bool isMat(std::string_view beginning);

/// Reads a model of TreeQSM from a MAT file as a skeleton; see `skeletonOf(const Qsm&, ...)` for
/// how.
///
/// The model is the first structure that has a field `cylinder`, or is one itself; of several
/// models in it, the first is taken, with a note. Of its cylinders the fields radius, length,
/// start, axis and parent are needed, and extension, branch and BranchOrder used if they are there;
/// the others are passed over.
///
/// @param file  its name, for messages
/// @throws Error if there is no such structure, a field is no table of numbers with a row per
///         cylinder, or the file is damaged, or of version 7.3; and as `skeletonOf`
/// Time O(size of the file, unpacked).
/// Source: TreeQSM 2.3 and 2.4, treeqsm.m and cylinders.m; lengths are in m there.
[[nodiscard]] Imported<Skeleton> readQsmMat(std::istream& in, const std::string& file);

} // namespace espalier
