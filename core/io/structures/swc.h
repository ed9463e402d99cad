#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is SWC: lines of 7 numbers, the first two and the last whole, and
/// a root among them, with the parent -1.
[[nodiscard]] bool isSwc(std::string_view beginning);

/// Skeleton of an SWC file: lines `id type x y z radius parent`, comments beginning with #; ids in
/// any order, a root has the parent -1, more columns than seven are passed over.
///
/// SWC has no edge types: the child that carries most continues an axis, as `withAssembledAxes`
/// chooses. Types are not kept. A radius that is not above 0 is not estimated.
///
/// @param file  its name, for messages
/// @throws Error naming the line that is no node, gives an id twice, or has a parent that is
///         missing or that it carries itself
/// Time O(N).
/// Specification: R. C. Cannon et al., "An on-line archive of reconstructed hippocampal neurons",
/// Journal of Neuroscience Methods 84, 1998.
[[nodiscard]] Imported<Skeleton> readSwc(std::istream& in, const std::string& file);

/// Writes ids from 1, each node after its parent, and right after it if it continues its axis; all
/// of type 0, which is undefined.
/// pre: positions and radii are finite
void writeSwc(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
