#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <functional>

namespace espalier {

/// Changes the entity of a scale at a node, which gets its own if it carries none.
/// @throws Error if nothing of this scale begins there
void changeEntity(SkeletonEditor& editor, NodeId id, int scale,
                  const std::function<void(Entity&)>& change);

} // namespace espalier
