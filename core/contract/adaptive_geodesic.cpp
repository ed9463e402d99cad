#include "core/contract/adaptive_geodesic.h"

#include "core/base/error.h"
#include "core/contract/ball_centers.h"
#include "core/contract/density_radii.h"
#include "core/graph/geodesic_balls.h"
#include "core/graph/orientations.h"

#include <vector>

namespace espalier {
namespace {

using Lanes = GeodesicBalls::Lanes;
using Centers = std::span<const std::uint32_t>;

/// The length of links as each of several centers sees it, by its own direction.
class StretchedLength {
public:
  StretchedLength(const Eigen::Matrix3Xf& points, const std::vector<Orientation>& orientations,
                  Centers centers, const AdaptiveGeodesicOptions& options)
      : points_(points), x_(Lanes::Zero()), y_(Lanes::Zero()), z_(Lanes::Zero()),
        along_(Lanes::Ones()), across_(Lanes::Ones()) {
    for (std::size_t i = 0; i < centers.size(); ++i) {
      const auto lane = static_cast<Eigen::Index>(i);
      const Eigen::Vector3f& direction = orientations[centers[i]].direction;
      if (direction.isZero()) continue; // it knows no along
      x_[lane] = direction.x();
      y_[lane] = direction.y();
      z_[lane] = direction.z();
      along_[lane] = static_cast<float>(options.along);
      across_[lane] = static_cast<float>(options.across);
    }
  }

  Lanes operator()(std::uint32_t from, const NeighborhoodGraph::Link& link) const {
    const Eigen::Vector3f d = points_.col(link.to) - points_.col(from);
    const Lanes along = (x_ * d.x() + y_ * d.y() + z_ * d.z()).square();
    const Lanes across = (link.length * link.length - along).max(0.0F);
    return (along_ * along + across_ * across).sqrt();
  }

private:
  const Eigen::Matrix3Xf& points_;
  Lanes x_;
  Lanes y_;
  Lanes z_;
  Lanes along_;
  Lanes across_;
};

} // namespace

Eigen::Matrix3Xf contractedAdaptively(const Eigen::Matrix3Xf& points,
                                      const AdaptiveGeodesicOptions& options,
                                      const Progress& progress) {
  if (options.along <= 0 && options.across <= 0)
    throw Error("contraction with no weight along and none across has no end: raise one of them");
  if (points.cols() < 2) return points;
  const NeighborhoodGraph graph(points, options.neighbors, progress.part(0, 0.2));
  const std::vector<float> radii = densityRadii(graph,
                                                {.densityRadius = options.densityRadius,
                                                 .least = options.leastRadius,
                                                 .most = options.mostRadius,
                                                 .curve = options.curve},
                                                progress.part(0.2, 0.3));
  const bool isStretched = options.along != 1 || options.across != 1;
  std::vector<Orientation> directions;
  if (isStretched)
    directions = orientations(points, graph, static_cast<float>(options.orientationRadius),
                              progress.part(0.3, 0.5));

  Eigen::Matrix3Xf result(3, points.cols());
  const auto radiusOf = [&](std::uint32_t center) { return radii[center]; };
  const auto find = [&](GeodesicBalls& balls, Centers centers, const Lanes& reach) {
    if (isStretched)
      balls.find(centers, reach, StretchedLength(points, directions, centers, options));
    else
      balls.find(centers, reach);
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
