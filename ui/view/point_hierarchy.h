#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace espalier {

/// What a pixel and its surroundings see: a cone, or in parallel projection a cylinder.
struct ViewCone {
  Eigen::Vector3f apex;      // [L]
  Eigen::Vector3f direction; // unit length
  float radius;              // [L], at the apex, >= 0
  float slope;               // growth of the radius per length, >= 0
};

/// Boxes over runs of points, to find what the pointer is on.
///
/// Relies on near points being near in memory, as in a PointCloud: made in one pass, without
/// sorting. Build O(N), a query about O(log N + points in the cone). Keeps no points.
class PointHierarchy {
public:
  PointHierarchy() = default;
  explicit PointHierarchy(const Eigen::Matrix3Xf& points); // 3 x N

  /// The point of the cone that the pointer means: near the eye and near the axis.
  /// pre: `points` are those it was made of
  [[nodiscard]] std::optional<Eigen::Index> pick(const Eigen::Matrix3Xf& points,
                                                 const ViewCone& cone) const;
  [[nodiscard]] Eigen::AlignedBox3f bounds() const;

private:
  std::vector<Eigen::AlignedBox3f> boxes_; // a complete binary tree in level order, root first
  Eigen::Index leaves_ = 0;                // a power of two
};

} // namespace espalier
