#pragma once

#include "core/graph/find_root.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <QImage>

#include <vector>

namespace espalier {

/// A small picture of a plant from its broader side, in a grey that is seen on light and on dark
/// ground; a square of `size` pixels. Any thread may make it. What points up is taken to be the
/// axis along which the wood lies farthest from the root.
[[nodiscard]] QImage pictureOf(const Skeleton& skeleton, int size);

/// The same of some points of a scan [L].
[[nodiscard]] QImage pictureOf(const std::vector<Eigen::Vector3d>& points, UpAxis up, int size);

} // namespace espalier
