#include "core/cloud/thin_wood.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"
#include "core/base/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {
namespace {

constexpr std::array balls = {2.0, 2.8, 4.0, 5.6, 8.0}; // radii [spacings]
constexpr double mostRatio = 0.35; // of the second deviation to the first, of points along a line
constexpr int fewest = 6;          // points that may show a line

/// [L]
double thicknessAround(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                       Eigen::Index point, double spacing) {
  const Eigen::Vector3f place = points.col(point);
  for (const double ball : balls) {
    Moments moments(place.cast<double>());
    for (const Neighbor& neighbor : index.within(place, static_cast<float>(ball * spacing)))
      moments.add(Eigen::Vector3f(points.col(neighbor.index)));
    if (moments.count() < fewest) continue;
    const Eigen::Vector3d variances = moments.components().eigenvalues().cwiseMax(0);
    if (variances[1] <= mostRatio * mostRatio * variances[2])
      return std::min(2 * std::sqrt(variances[0] + variances[1]), thickestThinWood * spacing);
  }
  return thickestThinWood * spacing;
}

} // namespace

double thinWood(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                const std::vector<Eigen::Index>& places, double spacing) {
  constexpr Eigen::Index samples = 2000;
  constexpr Eigen::Index fewestPlaces = 16;
  if (std::ssize(places) < fewestPlaces) return thickestThinWood * spacing;
  const Eigen::Index count = std::min(std::ssize(places), samples);
  std::vector<double> found(static_cast<std::size_t>(count));
  constexpr Eigen::Index grain = 64;
  parallelFor(
      count,
      [&](Eigen::Index i) {
        const auto place = static_cast<std::size_t>(i * std::ssize(places) / count);
        found[static_cast<std::size_t>(i)] = thicknessAround(points, index, places[place], spacing);
      },
      {}, grain);
  return *quantile(std::move(found), 0.25);
}

} // namespace espalier
