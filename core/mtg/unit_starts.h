#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <utility>
#include <vector>

namespace espalier {

/// The entity of each node itself, by id: the one it carries, else one of the class of its parent,
/// else of the first node that carries one; N of scale 2 if none does. Time O(nodes).
[[nodiscard]] std::vector<Entity> ownEntities(const Skeleton& skeleton);

/// Lets a unit of a coarser scale start at each of these nodes. Units of finer scales that go on
/// there are cut: another one of their class, without index, starts there too, so that units nest.
/// pre: no unit of this scale starts there yet; it is coarser than the nodes
/// Time O(nodes x scales).
void startUnits(SkeletonEditor& editor, const std::vector<std::pair<NodeId, Entity>>& starts);

} // namespace espalier
