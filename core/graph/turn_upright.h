#pragma once

#include "core/graph/find_root.h"

#include <Eigen/Core>

namespace espalier {

/// The turn after which a plant that stands along `up` stands along z: from the front one looks
/// along y then, and before along y, -z, or z of its file, where z, y, or x is up.
[[nodiscard]] Eigen::Matrix3d turnUpright(UpAxis up);

} // namespace espalier
