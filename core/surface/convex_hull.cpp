#include "core/surface/convex_hull.h"

#include "core/base/qhull.h"

#include <map>

namespace espalier {

std::optional<ConvexHull> convexHull(const Eigen::Matrix3Xd& points) {
  if (points.cols() < 4) return {};
  const Spread<3> spread(points);
  if (!spread.isSolid()) return {};
  const Facets facets(spread.centered);
  ConvexHull hull{
      .triangles = facets.triangles(), .volume = facets.volume(), .area = facets.area()};
  std::map<int, int> cornerOf; // by point
  for (std::array<int, 3>& triangle : hull.triangles)
    for (int& corner : triangle)
      corner = cornerOf.try_emplace(corner, static_cast<int>(cornerOf.size())).first->second;
  hull.corners.resize(3, static_cast<Eigen::Index>(cornerOf.size()));
  for (const auto& [point, corner] : cornerOf)
    hull.corners.col(corner) = points.col(point);
  return hull;
}

} // namespace espalier
