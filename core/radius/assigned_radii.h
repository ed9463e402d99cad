#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// The points of a scan, each with the node whose wood it is of: that of the nearer half of the
/// nearest edge. The lower half of an edge that branches off belongs to the branch, not to the axis
/// that bears it.
class AssignedPoints {
public:
  /// @param points 3 x N [L], in the frame of the skeleton after adding `origin`; outlives this
  /// @throws Cancelled if `progress` asks to stop
  /// Deterministic. Uses all threads. Time O(N log n).
  AssignedPoints(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                 const Eigen::Vector3d& origin, const Progress& progress = {});

  /// Columns of the points of a node, in rising order. pre: the skeleton contains it
  [[nodiscard]] std::span<const std::uint32_t> of(NodeId id) const {
    return {columns_.data() + begin_[indexOf(id)], columns_.data() + begin_[indexOf(id) + 1]};
  }
  /// How far a point is from the nearest edge [L].
  [[nodiscard]] double distance(std::uint32_t column) const { return distances_[column]; }
  /// A point in the frame of the skeleton [L].
  [[nodiscard]] Eigen::Vector3d position(std::uint32_t column) const {
    return points_.col(column).cast<double>() + origin_;
  }

private:
  const Eigen::Matrix3Xf& points_;
  Eigen::Vector3d origin_;
  std::vector<std::size_t> begin_; // by id, places in columns_
  std::vector<std::uint32_t> columns_;
  std::vector<double> distances_; // by column
};

/// What a radius is taken from.
enum class AssignedMeasure : std::uint8_t {
  mean,    // mean distance to the skeleton
  maximum, // 95 % of the points are nearer than this
  hull     // perimeter of the convex hull across the axis / 2 pi
};

/// A radius for each node from the points of its wood [L], by id; 0 where there are fewer than 3,
/// or where those of a hull lie on a line.
///
/// All are low on wood that is scanned from one side only, or where the skeleton is off its middle
/// towards the scanner; maximum and hull are high by noise.
/// Deterministic. Time O(N log N) for N points.
/// Source: the three measures of PlantScan3D. Differs: its maximum is that of the farthest point,
/// which is a stray one more often than not.
[[nodiscard]] std::vector<double>
assignedRadii(const Skeleton& skeleton, const AssignedPoints& points, AssignedMeasure measure);

/// `radii` [L] by id with those that are 0 filled in: between two nodes of an axis by its length,
/// beyond the last as there, on an axis without any as its parent, or, at a root, as what it
/// carries. All stay 0 if all are.
[[nodiscard]] std::vector<double> interpolatedRadii(const Skeleton& skeleton,
                                                    std::vector<double> radii);

/// Mean distance from the points around each node to the skeleton [L], by id; 0 where no point is
/// nearest to the node.
///
/// @param points 3 x N [L], in the frame of the skeleton after adding `origin`
/// Time O(N log n).
[[nodiscard]] std::vector<double> meanPointDistances(const Skeleton& skeleton,
                                                     const Eigen::Matrix3Xf& points,
                                                     const Eigen::Vector3d& origin,
                                                     const Progress& progress = {});

} // namespace espalier
