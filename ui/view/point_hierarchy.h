#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <functional>
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

  /// The point of the cone that the pointer means: near the eye and near the axis, of those that
  /// `accepts`, which is asked about few.
  /// pre: `points` are those it was made of
  [[nodiscard]] std::optional<Eigen::Index>
  pick(const Eigen::Matrix3Xf& points, const ViewCone& cone,
       const std::function<bool(Eigen::Index)>& accepts = {}) const;
  [[nodiscard]] Eigen::AlignedBox3f bounds() const;

  /// Distance from a place to the nearest point farther away than `beyond` [L]; infinite without.
  /// pre: `points` are those it was made of
  [[nodiscard]] float distance(const Eigen::Matrix3Xf& points, const Eigen::Vector3f& place,
                               float beyond = -1) const;

  /// Calls act(begin, end) for each run of columns whose box `mayMeet` something. In order.
  template <class MayMeet, class Act> void forEachRun(MayMeet mayMeet, Act act) const {
    std::vector<Eigen::Index> open;
    if (!boxes_.empty()) open.push_back(0);
    while (!open.empty()) {
      const Eigen::Index box = open.back();
      open.pop_back();
      const Eigen::AlignedBox3f& bounds = boxes_[static_cast<std::size_t>(box)];
      if (bounds.isEmpty() || !mayMeet(bounds)) continue;
      if (box >= leaves_ - 1) {
        const Eigen::Index begin = (box - (leaves_ - 1)) * runLength;
        act(begin, std::min(begin + runLength, points_));
      } else {
        open.push_back(2 * box + 2);
        open.push_back(2 * box + 1);
      }
    }
  }

private:
  static constexpr Eigen::Index runLength = 32;

  std::vector<Eigen::AlignedBox3f> boxes_; // a complete binary tree in level order, root first
  Eigen::Index leaves_ = 0;                // a power of two
  Eigen::Index points_ = 0;
};

} // namespace espalier
