#pragma once

#include "ui/tools/node_edits.h"

#include <vector>

namespace espalier {

/// Edits of what is attached to what, for a menu of their own.
[[nodiscard]] std::vector<NodeEdit> treeEdits();

/// Edits of the nodes along a path: between the first and the last of those chosen; of one alone,
/// its axis.
[[nodiscard]] std::vector<NodeEdit> pathEdits();

/// The menu that pathEdits() stand in.
[[nodiscard]] QString pathMenu();

/// Spaces the nodes of a path evenly, or those chosen if they are more than two ends.
/// @param step  wanted length of edges [L], > 0
/// @throws Error if it is refused
void resamplePath(PlantDocument& document, const std::vector<NodeId>& chosen, double step);

/// The mean length of edges among the nodes that resamplePath() spaces [L]; 0 if there is none.
[[nodiscard]] double pathSpacing(const Skeleton& skeleton, const std::vector<NodeId>& chosen);

} // namespace espalier
