#pragma once

#include "core/base/spatial_index.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/finding.h"
#include "core/skeleton/point_distances.h"

#include <optional>
#include <vector>

namespace espalier {

/// Which points are a branch's own, and not of wood that it does not carry. Refers to all it is
/// made of. Build O(n log n).
class OwnPoints {
public:
  /// @param index   of the positions of the cloud of `distances`
  /// @param spacing between neighboring points [L], > 0
  OwnPoints(const Skeleton& skeleton, const PointDistances& distances, const SpatialIndex& index,
            double spacing, const CheckOptions& options);

  /// Whether a place is so near to wood which a branch does not carry that points say nothing.
  [[nodiscard]] bool isBeside(NodeId branch, const Eigen::Vector3d& place) const;

  /// Whether a branch has points of its own about a place of it.
  /// @param radius of the wood there [L]
  [[nodiscard]] bool isSeen(NodeId branch, const Eigen::Vector3d& place, double radius) const;

  /// The stretch without points of its own that a branch begins with, if it is long.
  [[nodiscard]] std::optional<Finding> missing(NodeId branch) const;

private:
  /// Does `branch` carry `id`, or is it the same?
  [[nodiscard]] bool carries(NodeId branch, NodeId id) const {
    const std::size_t rank = rank_[indexOf(id)];
    return rank >= rank_[indexOf(branch)] && rank < end_[indexOf(branch)];
  }

  const Skeleton& skeleton_;
  const PointDistances& distances_;
  const SpatialIndex& index_;
  double spacing_; // [L]
  CheckOptions options_;
  EdgeIndex wood_;
  /// By id, in depth-first order, so that what a node carries is one run of ranks.
  std::vector<std::size_t> rank_, end_;
};

} // namespace espalier
