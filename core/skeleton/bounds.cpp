#include "core/skeleton/bounds.h"

namespace espalier {

Eigen::AlignedBox3d bounds(const Skeleton& skeleton) {
  Eigen::AlignedBox3d box;
  for (const NodeId id : skeleton.ids())
    box.extend(skeleton[id].position);
  return box;
}

} // namespace espalier
