#include "core/contract/adaptive_geodesic.h"

#include "core/base/shown_message.h"
#include "core/contract/ball_centers.h"
#include "core/contract/density_radii.h"
#include "core/contract/stretched_length.h"
#include "core/graph/geodesic_balls.h"
#include "core/graph/orientations.h"

#include <array>
#include <vector>

namespace espalier {
namespace {

using Lanes = GeodesicBalls::Lanes;
using Centers = std::span<const std::uint32_t>;

} // namespace

Eigen::Matrix3Xf contractedAdaptively(const Eigen::Matrix3Xf& points,
                                      const AdaptiveGeodesicOptions& options,
                                      const Progress& progress) {
  if (options.along <= 0 && options.across <= 0)
    throw ShownError({espalier::Shown::tr(
        "contraction with no weight along and none across has no end: raise one of them")});
  if (points.cols() < 2) return points;
  const NeighborhoodGraph graph(points, options.neighbors, progress.part(0, 0.2));
  const std::vector<float> radii = densityRadii(graph,
                                                {.densityRadius = options.densityRadius,
                                                 .least = options.leastRadius,
                                                 .most = options.mostRadius,
                                                 .curve = options.curve,
                                                 .measure = options.densityMeasure,
                                                 .levels = options.densityLevels},
                                                progress.part(0.2, 0.3));
  const bool isStretched = options.along != 1 || options.across != 1;
  std::vector<Orientation> directions;
  if (isStretched)
    directions = orientations(points, graph, static_cast<float>(options.orientationRadius),
                              progress.part(0.3, 0.5));

  Eigen::Matrix3Xf result(3, points.cols());
  const auto radiusOf = [&](std::uint32_t center) { return radii[center]; };
  const auto find = [&](GeodesicBalls& balls, Centers centers, const Lanes& reach) {
    if (!isStretched) {
      balls.find(centers, reach);
      return;
    }
    std::array<Eigen::Vector3f, GeodesicBalls::most> own;
    for (std::size_t i = 0; i < centers.size(); ++i)
      own[i] = directions[centers[i]].direction;
    const std::span<const Eigen::Vector3f> ofCenters(own.data(), centers.size());
    balls.find(centers, reach, StretchedLength(points, ofCenters, options.along, options.across));
  };
  const auto contract = [&](const GeodesicBalls& balls) {
    Lanes reach = Lanes::Zero();
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      reach[static_cast<Eigen::Index>(i)] = radii[balls.centers()[i]];
    putCenters(balls, points, reach, options.fitsCircles, result);
  };
  forEachGeodesicBalls(graph, radiusOf, find, contract, progress.part(0.5, 1));
  return result;
}

} // namespace espalier
