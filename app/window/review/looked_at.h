#pragma once

#include "core/skeleton/skeleton.h"

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

/// Nodes may be marked reviewed by a key if they are seen, be it behind wood, and are no more than
/// one looks at in one go (isOneLook in core/skeleton/review_walk.h).
/// @throws Error that says why they may not, and what to choose. pre: the skeleton has the nodes
void requireLookedAt(const Seen& seen, const std::vector<NodeId>& nodes, const ActionSet& actions);

} // namespace espalier
