#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is a node list.
[[nodiscard]] bool isNodeList(std::string_view beginning);

/// Skeleton of a node list as PlantScan3D exports it: comments, one of which names the columns
/// "vid parentid edgetype XX YY ZZ Radius", the number of nodes, then a node per line, parted by
/// tabs.
///
/// The parent of a root is empty, "None" or -1. An edge that is not + is a successor. An empty
/// radius is not estimated. Nodes get new ids, breadth first from the roots, successors first.
///
/// @param file  its name, for messages
/// @throws Error naming the line that is no node, gives an id twice, or has a parent that is
/// missing
///         or that it carries itself
/// Time O(N).
[[nodiscard]] Imported<Skeleton> readNodeList(std::istream& in, const std::string& file);

/// Writes a node list; ids count from 1, parents before their children.
/// pre: positions and radii are finite
void writeNodeList(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
