#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <limits>
#include <vector>

namespace espalier {

/// What the points about a place sample.
struct SampledSurface {
  /// How much a distance matters, by its direction: 1 across a plane or a line, near 0 along it.
  Eigen::Matrix3d across;
  /// Unit, toward the scanner; zero: nobody knows where that stood, or the points give no plane.
  Eigen::Vector3d facing = Eigen::Vector3d::Zero();
};

/// A cloud of one scale.
struct SampledCloud {
  Eigen::Matrix3Xf points;              // 3 x N about the origin of the cloud [L]
  std::vector<SampledSurface> surfaces; // N
};

/// One point per cube, the one nearest to the mean of those in it, and what the 12 about each
/// sample that the same station has seen: two stations see two sides of a twig, which together are
/// no surface.
/// @param edge  of a cube [L], > 0
/// @param most  points; of more, as many are taken evenly
/// Deterministic, on all threads. Time O(N log N). @throws Cancelled if `progress` asks to stop
[[nodiscard]] SampledCloud sampled(const PointCloud& cloud, double edge, Eigen::Index most,
                                   const Progress& progress = {});

/// A point of the moved cloud where it lies now, and its counterpart.
struct CloudPair {
  Eigen::Vector3d place;  // [L]
  Eigen::Vector3d target; // [L]
  Eigen::Matrix3d across; // how much the distance between them matters, by its direction
  double squared = std::numeric_limits<double>::infinity(); // [L^2]; infinite: there is none
};

/// Two clouds of one scale, laid on each other about the origin of the fixed one.
class CloudMatching {
public:
  /// Both outlive it. @throws Cancelled if `progress` asks to stop
  CloudMatching(const SampledCloud& fixed, const SampledCloud& moved, const Progress& progress = {})
      : fixed_(fixed), moved_(moved), index_(fixed.points, progress) {}

  /// A pair for each moved point, in their order: with the nearest fixed one within reach that does
  /// not face away from it. Where it is known how both face, distance matters along the middle of
  /// the two alone: that is 0 between any two places of one ball or stem.
  /// @param agreement  least cosine between the directions that the surfaces of a pair face; 0 lets
  ///                   those be pairs, too, that face nowhere
  /// On all threads. @throws Cancelled if `progress` asks to stop
  [[nodiscard]] std::vector<CloudPair> pairs(const Eigen::Isometry3d& motion, double reach,
                                             double agreement, const Progress& progress = {}) const;

private:
  const SampledCloud& fixed_;
  const SampledCloud& moved_;
  SpatialIndex index_;
};

} // namespace espalier
