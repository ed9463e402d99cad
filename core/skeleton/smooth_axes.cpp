#include "core/skeleton/smooth_axes.h"

#include "core/skeleton/axes.h"

#include <optional>
#include <utility>

namespace espalier {

Skeleton withSmoothAxes(const Skeleton& skeleton, double share, int rounds) {
  Skeleton result = skeleton;
  for (int round = 0; round < rounds; ++round) {
    const Skeleton before = result;
    for (const NodeId id : before.ids()) {
      const Node& node = before[id];
      const std::optional<NodeId> next = nextOnAxis(before, id);
      if (!node.parent || node.edge != EdgeType::successor || !next) continue;
      const Eigen::Vector3d mean = (before[*node.parent].position + before[*next].position) / 2;
      result.setPosition(id, (1 - share) * node.position + share * mean);
    }
  }
  return result;
}

} // namespace espalier
