#pragma once

#include "core/base/progress.h"
#include "core/graph/find_root.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <vector>

namespace espalier::test {

/// Points about `spacing` apart, jittered, on a cylinder about the line from `from` to `to`.
[[nodiscard]] Eigen::Matrix3Xf cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                        double radius, double spacing, std::uint64_t seed = 1);

/// Extent of the points along `up` [L].
[[nodiscard]] double heightOf(const Eigen::Matrix3Xf& points, UpAxis up);

[[nodiscard]] Eigen::Matrix3Xf both(const Eigen::Matrix3Xf& a, const Eigen::Matrix3Xf& b);

/// A trunk 2 high from the origin, forking into two arms 1.5 long, 35 degrees off to either side;
/// radius 0.04, points 0.02 apart.
[[nodiscard]] Eigen::Matrix3Xf forkCloud(std::uint64_t seed = 1);

/// Greatest distance from a node to the nearest place of the true axes of forkCloud().
[[nodiscard]] double farthestFromFork(const Skeleton& skeleton);

/// Runs `work` with a Progress that is asked to stop before it starts.
/// @return whether it threw Cancelled
[[nodiscard]] bool stopsWhenAsked(const std::function<void(const Progress&)>& work);

} // namespace espalier::test
