#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <QString>

#include <vector>

namespace espalier {

class ActionSet;
class PlantView;

/// What a reviewer sees.
struct Seen {
  const Skeleton& skeleton;
  const std::vector<NodeId>& hidden;   // in order
  std::vector<const PlantView*> views; // nodes are seen in any of them; not empty
};

/// Nodes may be marked reviewed by a key if they are no more than one looks at in one go (isOneLook
/// in core/skeleton/review_walk.h), and the skeleton is shown.
/// @throws Error that says why they may not, and what to choose. pre: the skeleton has the nodes
void requireOneLook(const Skeleton& skeleton, const std::vector<NodeId>& nodes,
                    const ActionSet& actions);

/// "3 of the 8 nodes selected were hidden": which nodes, each with the edge to its parent, are not
/// seen, be it behind wood; empty: all are. pre: the skeleton has the nodes
[[nodiscard]] QString unseenText(const Seen& seen, const std::vector<NodeId>& nodes);

/// Whether all of some places are in one view at least, be it behind wood [L].
[[nodiscard]] bool areSeen(const Seen& seen, const std::vector<Eigen::Vector3d>& places);

} // namespace espalier
