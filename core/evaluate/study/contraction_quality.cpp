#include "core/evaluate/study/contraction_quality.h"

#include "core/base/moments.h"
#include "core/base/spatial_index.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/study/bridges.h"
#include "core/evaluate/study/thinned_plant.h"
#include "core/graph/geodesic_balls.h"
#include "core/skeleton/assign_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

constexpr double nearReach = 10; // these in point spacings
constexpr double shortestBranch = 14;
constexpr double lostReach = 7;
constexpr double explainedReach = 3;
constexpr double leastShareAlong = 0.9;

/// The line through the contracted points near a point.
struct LocalAxis {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double thickness = 0; // root mean square distance from it [L]
  bool isLine = false;

  [[nodiscard]] double distance(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d d = place - middle;
    return (d - d.dot(direction) * direction).norm();
  }
};

LocalAxis axisOf(const Moments& moments) {
  const auto components = moments.components();
  const Eigen::Vector3d variances = components.eigenvalues().cwiseMax(0);
  return {.middle = moments.mean(),
          .direction = components.eigenvectors().col(2),
          .thickness = std::sqrt(variances[0] + variances[1]),
          .isLine = variances[2] > leastShareAlong * variances.sum()};
}

/// By cube.
std::vector<LocalAxis> localAxes(const ThinnedPlant& plant, const Eigen::Matrix3Xf& places,
                                 double reach, const Progress& progress) {
  std::vector<LocalAxis> axes(plant.points.size());
  const auto visit = [&](const GeodesicBalls& balls) {
    std::array<Moments, GeodesicBalls::most> moments;
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      moments[i] = Moments(places.col(balls.centers()[i]).cast<double>());
    balls.forEachMember([&](std::size_t center, std::uint32_t cube, float /*distance*/) {
      moments[center].add(Eigen::Vector3f(places.col(cube)));
    });
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      axes[balls.centers()[i]] = axisOf(moments[i]);
  };
  const auto find = [&](GeodesicBalls& balls, std::span<const std::uint32_t> centers,
                        const GeodesicBalls::Lanes& radii) {
    balls.find(centers, radii, [&](std::uint32_t, const NeighborhoodGraph::Link& link) {
      return plant.holds(link) ? link.length : std::numeric_limits<float>::infinity();
    });
  };
  const auto radiusOf = [&](std::uint32_t /*center*/) { return reach; };
  forEachGeodesicBalls(plant.graph, radiusOf, find, visit, progress);
  return axes;
}

/// What of the axes makes the numbers of thickness, and those of all points.
void measureThickness(const ThinnedPlant& plant, const std::vector<LocalAxis>& axes,
                      const Eigen::Matrix3Xf& contracted, double spacing,
                      ContractionQuality& quality) {
  std::vector<double> thicknesses;
  double onLine = 0;
  double counted = 0;
  for (std::size_t cube = 0; cube < axes.size(); ++cube) {
    if (plant.isDust[cube]) continue;
    thicknesses.push_back(axes[cube].thickness / spacing);
    counted += static_cast<double>(plant.counts[cube]);
    if (axes[cube].isLine) onLine += static_cast<double>(plant.counts[cube]);
  }
  if (thicknesses.empty()) return;
  const auto middle = thicknesses.begin() + static_cast<std::ptrdiff_t>(thicknesses.size() / 2);
  std::ranges::nth_element(thicknesses, middle);
  quality.residualThickness = *middle;
  quality.shareOnLine = onLine / counted;
  for (std::size_t i = 0; i < plant.cubeOf.size(); ++i) {
    const std::uint32_t cube = plant.cubeOf[i];
    if (plant.isDust[cube]) continue;
    const Eigen::Vector3d place = contracted.col(static_cast<Eigen::Index>(i)).cast<double>();
    quality.thicknesses[i] = static_cast<float>(axes[cube].thickness / spacing);
    quality.residuals[i] = static_cast<float>(axes[cube].distance(place) / spacing);
  }
}

/// How many of the ends have none of `places` near them.
Eigen::Index countLost(const ThinnedPlant& plant, const std::vector<std::uint32_t>& ends,
                       const Eigen::Matrix3Xf& places, double reach, const Progress& progress) {
  if (places.cols() == 0) return static_cast<Eigen::Index>(ends.size());
  const SpatialIndex index(places, progress);
  const auto isLost = [&](std::uint32_t end) {
    const Neighbor nearest = index.nearest(plant.positions.col(end), 1).front();
    return static_cast<double>(nearest.squaredDistance) > reach * reach;
  };
  return std::ranges::count_if(ends, isLost);
}

/// Nodes with no child, about `origin`.
Eigen::Matrix3Xf apices(const Skeleton& skeleton, const Eigen::Vector3d& origin) {
  std::vector<Eigen::Vector3f> places;
  for (const NodeId id : skeleton.ids())
    if (skeleton.children(id).empty())
      places.emplace_back((skeleton[id].position - origin).cast<float>());
  Eigen::Matrix3Xf result(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = places[i];
  return result;
}

Eigen::Index countUnexplained(const ThinnedPlant& plant, const Eigen::Matrix3Xf& places,
                              const Skeleton& skeleton, const Eigen::Vector3d& origin, double reach,
                              const Progress& progress) {
  std::vector<PointOnSkeleton> nearest;
  if (!skeleton.isEmpty()) nearest = assignPoints(places, origin, skeleton, progress);
  Eigen::Index count = 0;
  for (std::size_t cube = 0; cube < plant.points.size(); ++cube) {
    if (plant.isDust[cube]) continue;
    if (skeleton.isEmpty() || nearest[cube].distance > reach + skeleton[nearest[cube].child].radius)
      count += plant.counts[cube];
  }
  return count;
}

/// All that needs no skeleton, but for lost tips.
struct Judged {
  ThinnedPlant plant;
  Eigen::Matrix3Xf places; // by cube
  std::vector<std::uint32_t> ends;
  ContractionQuality quality;
};

Judged judged(const Eigen::Matrix3Xf& points, const Eigen::Matrix3Xf& contracted,
              const ContractionQualityOptions& options, const Progress& progress) {
  const double spacing = options.spacing;
  Judged result{.plant = thinnedPlant(points, spacing, options.root, progress.part(0, 0.5)),
                .places = {},
                .ends = {},
                .quality = {}};
  for (std::vector<float>* byPoint : {&result.quality.thicknesses, &result.quality.residuals})
    byPoint->assign(static_cast<std::size_t>(points.cols()),
                    std::numeric_limits<float>::quiet_NaN());
  result.places = contracted(Eigen::all, result.plant.points);
  const std::vector<LocalAxis> axes =
      localAxes(result.plant, result.places, nearReach * spacing, progress.part(0.5, 0.9));
  measureThickness(result.plant, axes, contracted, spacing, result.quality);
  result.ends = endsOf(result.plant, shortestBranch * spacing);
  result.quality.tips = static_cast<Eigen::Index>(result.ends.size());
  result.quality.bridgedJunctions = countBridges(result.plant, result.places, spacing);
  return result;
}

} // namespace

ContractionQuality contractionQuality(const Eigen::Matrix3Xf& points,
                                      const Eigen::Matrix3Xf& contracted,
                                      const ContractionQualityOptions& options,
                                      const Progress& progress) {
  Judged result = judged(points, contracted, options, progress.part(0, 0.95));
  result.quality.lostTips = countLost(result.plant, result.ends, result.places,
                                      lostReach * options.spacing, progress.part(0.95, 1));
  return std::move(result.quality);
}

ContractionQuality contractionQuality(const Eigen::Matrix3Xf& points,
                                      const Eigen::Matrix3Xf& contracted, const Skeleton& skeleton,
                                      const Eigen::Vector3d& origin,
                                      const ContractionQualityOptions& options,
                                      const Progress& progress) {
  Judged result = judged(points, contracted, options, progress.part(0, 0.8));
  result.quality.lostTips = countLost(result.plant, result.ends, apices(skeleton, origin),
                                      lostReach * options.spacing, progress);
  result.quality.skeletonLength = totalLength(skeleton);
  result.quality.nodes = static_cast<Eigen::Index>(skeleton.size());
  result.quality.unexplainedPoints =
      countUnexplained(result.plant, result.places, skeleton, origin,
                       explainedReach * options.spacing, progress.part(0.8, 1));
  return std::move(result.quality);
}

} // namespace espalier
