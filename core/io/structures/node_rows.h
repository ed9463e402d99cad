#pragma once

#include "core/base/shown_message.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace espalier {

/// A node as a table lists it.
struct NodeRow {
  std::string id;
  std::string parent;    // id of another row; empty for a root
  Node node;             // but for its parent
  std::size_t place = 0; // in the file: a line, say
};

/// The skeleton of rows in any order. Nodes are numbered breadth first from the roots, successors
/// before their siblings.
///
/// @param where  a row is in its file, for messages
/// @throws ShownError for an id that occurs twice, a parent that is missing, a node among its own
///         ancestors, and one that is not in range (isInRange)
/// Time O(N).
[[nodiscard]] Skeleton skeletonOfRows(const std::vector<NodeRow>& rows,
                                      const std::function<FilePlace(const NodeRow&)>& where);

/// What a user should know of a file whose format has no edge types.
[[nodiscard]] ShownMessage noteOnAxes(const std::string& file);

} // namespace espalier
