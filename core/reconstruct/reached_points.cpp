#include "core/reconstruct/reached_points.h"

#include "core/base/parallel.h"
#include "core/base/shown_message.h"
#include "core/base/spatial_index.h"

#include <cmath>
#include <string>
#include <vector>

namespace espalier {

void requireHalf(Eigen::Index reached, Eigen::Index all) {
  if (2 * reached < all)
    throw ShownError({Shown::tr("only %1 % of the points are connected to the root: choose another "
                                "root, or allow wider gaps"),
                      {std::to_string(100 * reached / all)}});
}

Skeleton withMeanDistances(Skeleton skeleton, const Eigen::Matrix3Xf& points,
                           const Progress& progress) {
  const std::vector<NodeId> ids = skeleton.ids();
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = skeleton[ids[i]].position.cast<float>();
  const SpatialIndex index(places);
  std::vector<Neighbor> nearest(static_cast<std::size_t>(points.cols()));
  parallelFor(
      points.cols(),
      [&](Eigen::Index point) {
        nearest[static_cast<std::size_t>(point)] = *index.nearestOne(points.col(point));
      },
      progress);
  std::vector<double> sums(ids.size(), 0);
  std::vector<double> counts(ids.size(), 0);
  for (const Neighbor& each : nearest) {
    sums[static_cast<std::size_t>(each.index)] +=
        std::sqrt(static_cast<double>(each.squaredDistance));
    counts[static_cast<std::size_t>(each.index)] += 1;
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
    skeleton.setRadius(ids[i], counts[i] > 0 ? sums[i] / counts[i] : 0);
  return skeleton;
}

} // namespace espalier
