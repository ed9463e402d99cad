#include "tests/support/course.h"

#include "core/base/spatial_index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier::test {
namespace {

double turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

} // namespace

Course courseOf(const Skeleton& plant, const std::vector<NodeId>& added, const PointCloud& cloud) {
  const SpatialIndex index(cloud.positions());
  const auto distance = [&](const Eigen::Vector3d& place) {
    const auto local = (place - cloud.origin()).cast<float>();
    return std::sqrt(static_cast<double>(index.nearest(local, 1).front().squaredDistance));
  };
  Course course{.nodes = added.size()};
  for (const NodeId id : added) {
    const Node& node = plant[id];
    const Node& below = plant[*node.parent];
    const Eigen::Vector3d edge = node.position - below.position;
    if (below.parent)
      course.sharpestTurn =
          std::max(course.sharpestTurn, turn(below.position - plant[*below.parent].position, edge));
    course.farthestNode = std::max(course.farthestNode, distance(node.position) - node.radius);
    constexpr int parts = 10;
    for (int i = 1; i < parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      const double wood = below.radius + share * (node.radius - below.radius);
      course.farthestOnEdge =
          std::max(course.farthestOnEdge, distance(below.position + share * edge) - wood);
    }
  }
  return course;
}

} // namespace espalier::test
