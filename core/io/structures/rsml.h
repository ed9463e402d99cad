#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is RSML, the Root System Markup Language.
[[nodiscard]] bool isRsml(std::string_view beginning);

/// Skeleton of the root systems of an RSML file: each root is an axis along its polyline.
///
/// A root within another branches off the node that its property parent-node numbers, from 0 along
/// the polyline of the other, else off the nearest node; where its first point lies on that node,
/// it stands for it. Points have two coordinates or three (z is 0 then); they stay in the unit of
/// the file, which the notes state. Radii are half of the function diameter over the polyline.
/// Other functions, properties, annotations and roots without a polyline are left out, with a note.
///
/// @param file  its name, for messages
/// @throws Error naming the line that is wrong
/// Time O(size of the file), but for roots whose nearest node is looked for.
/// Specification: G. Lobet et al., "Root System Markup Language: toward a unified root architecture
/// description language", Plant Physiology 167, 2015; http://rootsystemml.github.io.
[[nodiscard]] Imported<Skeleton> readRsml(std::istream& in, const std::string& file);

/// Writes a plant per tree and a root per axis, within the one it branches off, which its first
/// point lies on; with property parent-node and, where there are radii, function diameter.
/// pre: positions and radii are finite
void writeRsml(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
