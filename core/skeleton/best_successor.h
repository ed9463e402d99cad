#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// Of children of one node, the one that goes on straightest and thickest, as weighedAxes weighs
/// these: what it carries has no say. pre: not empty. Time O(children).
[[nodiscard]] NodeId bestSuccessor(const Skeleton& skeleton, const std::vector<NodeId>& children);

} // namespace espalier
