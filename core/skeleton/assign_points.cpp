#include "core/skeleton/assign_points.h"

#include "core/base/parallel.h"
#include "core/skeleton/edge_index.h"

namespace espalier {
namespace {

PointOnSkeleton onEdge(const Eigen::Vector3d& point, const Skeleton& skeleton, NodeId child) {
  const Frustum edge = centerLine(skeleton, child);
  const double share = edge.nearestShare(point);
  return {child, share, (point - edge.from - share * (edge.to - edge.from)).norm()};
}

/// Where several edges meet, their own comes before those of the children: it is taken if no
/// child's is nearer to the last bit.
PointOnSkeleton atNode(const Eigen::Vector3d& point, const Skeleton& skeleton, NodeId node) {
  const std::vector<NodeId>& children = skeleton.children(node);
  // A root stands for a place of its own only where no edge ends at it.
  const bool isRoot = !skeleton[node].parent && !children.empty();
  PointOnSkeleton best = onEdge(point, skeleton, isRoot ? children.front() : node);
  for (const NodeId child : children)
    if (const PointOnSkeleton found = onEdge(point, skeleton, child);
        found.distance < best.distance)
      best = found;
  return best;
}

} // namespace

std::vector<PointOnSkeleton> assignPoints(const Eigen::Matrix3Xf& points,
                                          const Eigen::Vector3d& origin, const Skeleton& skeleton,
                                          const Progress& progress) {
  const EdgeIndex index(skeleton);
  std::vector<PointOnSkeleton> result(static_cast<std::size_t>(points.cols()));
  const auto assign = [&](Eigen::Index i) {
    const Eigen::Vector3d point = points.col(i).cast<double>() + origin;
    const NearestPlace near = *index.nearest(point);
    const bool isBelow = near.share == 0; // at the parent
    result[static_cast<std::size_t>(i)] =
        near.share > 0 && near.share < 1
            ? onEdge(point, skeleton, near.node)
            : atNode(point, skeleton, isBelow ? *skeleton[near.node].parent : near.node);
  };
  parallelFor(points.cols(), assign, progress);
  return result;
}

} // namespace espalier
