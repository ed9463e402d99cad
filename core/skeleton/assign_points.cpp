#include "core/skeleton/assign_points.h"

#include "core/base/parallel.h"
#include "core/base/spatial_index.h"

#include <algorithm>
#include <limits>

namespace espalier {
namespace {

PointOnSkeleton onEdge(const Eigen::Vector3d& point, const Skeleton& skeleton, NodeId child) {
  const Node& node = skeleton[child];
  if (!node.parent) return {child, 1, (point - node.position).norm()};
  const Eigen::Vector3d start = skeleton[*node.parent].position;
  const Eigen::Vector3d along = node.position - start;
  const double squaredLength = along.squaredNorm();
  const double fraction =
      squaredLength > 0 ? std::clamp((point - start).dot(along) / squaredLength, 0.0, 1.0) : 1.0;
  return {child, fraction, (point - start - fraction * along).norm()};
}

} // namespace

std::vector<PointOnSkeleton> assignPoints(const Eigen::Matrix3Xf& points,
                                          const Eigen::Vector3d& origin, const Skeleton& skeleton,
                                          int tried, const Progress& progress) {
  const std::vector<NodeId> ids = skeleton.ids();
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = (skeleton[ids[i]].position - origin).cast<float>();
  const SpatialIndex index(places);
  std::vector<PointOnSkeleton> result(static_cast<std::size_t>(points.cols()));
  const auto assign = [&](Eigen::Index i) {
    const Eigen::Vector3d point = points.col(i).cast<double>() + origin;
    PointOnSkeleton best{ids.front(), 1, std::numeric_limits<double>::infinity()};
    const auto tryEdge = [&](NodeId child) {
      const PointOnSkeleton found = onEdge(point, skeleton, child);
      if (found.distance < best.distance) best = found;
    };
    for (const Neighbor& near : index.nearest(points.col(i), tried)) {
      const NodeId id = ids[static_cast<std::size_t>(near.index)];
      // A root stands for a place of its own only where no edge ends at it.
      if (skeleton[id].parent || skeleton.children(id).empty()) tryEdge(id);
      for (const NodeId child : skeleton.children(id))
        tryEdge(child);
    }
    result[static_cast<std::size_t>(i)] = best;
  };
  parallelFor(points.cols(), assign, progress);
  return result;
}

} // namespace espalier
