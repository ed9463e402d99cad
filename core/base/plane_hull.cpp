#include "core/base/plane_hull.h"

#include "core/base/qhull.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace espalier {

std::vector<Eigen::Vector2d> planeHull(const std::vector<Eigen::Vector2d>& places) {
  if (places.empty()) return {};
  const Eigen::Map<const Eigen::Matrix2Xd> points(places.front().data(), 2, std::ssize(places));
  const Spread<2> spread(points);
  std::vector<Eigen::Index> corners =
      spread.isSolid() ? Facets(spread.centered).corners() : spread.ends();
  const auto angle = [&](Eigen::Index i) {
    return std::atan2(spread.centered(1, i), spread.centered(0, i));
  };
  std::ranges::sort(corners, {}, angle);
  const auto place = [&](Eigen::Index i) { return std::pair(points(0, i), points(1, i)); };
  std::ranges::rotate(corners, std::ranges::min_element(corners, {}, place));
  std::vector<Eigen::Vector2d> hull;
  for (const Eigen::Index i : corners)
    hull.emplace_back(points.col(i));
  return hull;
}

} // namespace espalier
