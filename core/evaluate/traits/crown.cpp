#include "core/evaluate/traits/crown.h"

#include "core/base/plane_hull.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/bounds.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

} // namespace

CrownDimensions crownDimensions(const Skeleton& skeleton) {
  CrownDimensions crown;
  if (skeleton.isEmpty()) return crown;
  const Eigen::AlignedBox3d box = bounds(skeleton);
  crown.height = box.sizes().z();
  const std::vector<int> orderOf = orders(skeleton);
  double base = std::numeric_limits<double>::infinity();
  std::vector<Vector2d> places;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (orderOf[indexOf(id)] < 1) continue;
    places.emplace_back(node.position.head<2>());
    if (node.edge != EdgeType::branching) continue;
    const Eigen::Vector3d& foot = skeleton[*node.parent].position;
    places.emplace_back(foot.head<2>());
    base = std::min(base, foot.z());
  }
  if (places.empty()) return crown;
  crown.baseHeight = base - box.min().z();
  crown.depth = box.max().z() - base;
  const std::vector<Vector2d> hull = planeHull(places);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d& next = hull[(i + 1) % hull.size()];
    crown.area += cross(hull[i] - hull[0], next - hull[0]) / 2;
    for (std::size_t k = i + 1; k < hull.size(); ++k)
      crown.spread = std::max(crown.spread, (hull[k] - hull[i]).norm());
  }
  crown.diameter = 2 * std::sqrt(crown.area / std::numbers::pi);
  return crown;
}

} // namespace espalier
