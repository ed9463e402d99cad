#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <functional>

namespace espalier {

/// Gives the place on the points near a place [L], or itself where there are none.
using SnapToPoints = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// Where a new child of `parent` is likely to belong [L].
///
/// A node without children continues its own segment; another one tries ten directions turned about
/// the direction of view, and takes the place farthest from its other neighbors. Places are snapped
/// unless that would lead back to the parent. A node that has no neighbor grows upward by `step`.
/// @param viewDirection into the screen, not zero
/// @param step length to grow a lone root by [L], > 0
/// Source: PlantScan3D's "New child".
/// pre: contains(parent)
[[nodiscard]] Eigen::Vector3d proposeChild(const Skeleton& skeleton, NodeId parent,
                                           const Eigen::Vector3d& viewDirection, double step,
                                           const SnapToPoints& snap);

} // namespace espalier
