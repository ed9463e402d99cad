#include "core/graph/orientations.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"
#include "core/graph/geodesic_balls.h"

#include <algorithm>
#include <array>

namespace espalier {
namespace {

/// Of a point and those linked to it.
Moments linkedTo(const Eigen::Matrix3Xf& points, const NeighborhoodGraph& graph,
                 Eigen::Index point) {
  Moments moments(points.col(point).cast<double>());
  moments.add(Eigen::Vector3f(points.col(point)));
  for (const NeighborhoodGraph::Link& link : graph.links(point))
    moments.add(Eigen::Vector3f(points.col(link.to)));
  return moments;
}

} // namespace

Orientation orientationOf(const Moments& moments) {
  const auto components = moments.components();
  const Eigen::Vector3d& variances = components.eigenvalues();
  if (!(variances[2] > 0)) return {};
  return {.direction = components.eigenvectors().col(2).cast<float>(),
          .linearity = static_cast<float>(
              std::clamp((variances[2] - variances[1]) / variances[2], 0.0, 1.0))};
}

std::vector<Orientation> orientations(const Eigen::Matrix3Xf& points,
                                      const NeighborhoodGraph& graph, float radius,
                                      const Progress& progress) {
  std::vector<Orientation> result(static_cast<std::size_t>(points.cols()));
  if (radius <= 0) {
    const auto orient = [&](Eigen::Index i) {
      result[static_cast<std::size_t>(i)] = orientationOf(linkedTo(points, graph, i));
    };
    parallelFor(points.cols(), orient, progress);
    return result;
  }
  const auto visit = [&](const GeodesicBalls& balls) {
    std::array<Moments, GeodesicBalls::most> moments;
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      moments[i] = Moments(points.col(balls.centers()[i]).cast<double>());
    balls.forEachMember([&](std::size_t center, std::uint32_t point, float /*distance*/) {
      moments[center].add(Eigen::Vector3f(points.col(point)));
    });
    for (std::size_t i = 0; i < balls.centers().size(); ++i) {
      const std::uint32_t center = balls.centers()[i];
      if (moments[i].count() < 3) moments[i] = linkedTo(points, graph, center);
      result[center] = orientationOf(moments[i]);
    }
  };
  forEachGeodesicBalls(
      graph, [&](std::uint32_t /*center*/) { return radius; }, visit, progress);
  return result;
}

} // namespace espalier
