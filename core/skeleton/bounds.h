#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Geometry>

namespace espalier {

/// The box about all nodes [L], frame of the file; empty without nodes. O(N).
[[nodiscard]] Eigen::AlignedBox3d bounds(const Skeleton& skeleton);

} // namespace espalier
