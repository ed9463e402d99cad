#include "core/surface/subtree_hulls.h"

#include "core/skeleton/select.h"

namespace espalier {
namespace {

Eigen::Matrix3Xd pointsOf(const std::vector<NodeId>& carried, const PointDistances& distances,
                          const Skeleton& skeleton) {
  std::vector<bool> isCarried(skeleton.idEnd(), false);
  for (const NodeId id : carried)
    isCarried[indexOf(id)] = true;
  std::vector<Eigen::Index> points;
  for (std::size_t i = 0; i < distances.nearest().size(); ++i)
    if (isCarried[indexOf(distances.nearest()[i])]) points.push_back(static_cast<Eigen::Index>(i));
  const PointCloud& cloud = *distances.cloud();
  return cloud.positions()(Eigen::all, points).cast<double>().colwise() + cloud.origin();
}

} // namespace

std::vector<std::optional<ConvexHull>> subtreeHulls(const PointDistances& distances,
                                                    const Skeleton& skeleton,
                                                    const std::vector<NodeId>& nodes,
                                                    const Progress& progress) {
  std::vector<std::optional<ConvexHull>> hulls;
  hulls.reserve(nodes.size());
  for (const NodeId id : nodes) {
    progress.update(static_cast<double>(hulls.size()) / static_cast<double>(nodes.size()));
    hulls.push_back(convexHull(pointsOf(downstream(skeleton, {id}), distances, skeleton)));
  }
  return hulls;
}

} // namespace espalier
