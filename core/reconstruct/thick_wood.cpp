#include "core/reconstruct/thick_wood.h"

#include "core/graph/components.h"
#include "core/graph/neighborhood_graph.h"
#include "core/reconstruct/geodesic_groups.h"

#include <cmath>
#include <limits>

namespace espalier {
namespace {

/// The pieces of wood before and behind one: of several the one with most points.
struct Beside {
  std::uint32_t below = noGroup;
  std::uint32_t above = noGroup;
};

Beside besideOf(const GeodesicGroups& groups, std::uint32_t group) {
  Beside beside;
  for (const std::uint32_t other : groups.adjacent[group]) {
    std::uint32_t& side = groups.bins[other] < groups.bins[group] ? beside.below : beside.above;
    if (side == noGroup || groups.sizes[other] > groups.sizes[side]) side = other;
  }
  return beside;
}

/// The mean distance of the points of each piece to its axis [L].
std::vector<double> thicknesses(const GeodesicGroups& groups, const std::vector<Beside>& beside,
                                const Eigen::Matrix3Xf& points) {
  std::vector<Eigen::Vector3d> directions = groups.axes;
  for (std::size_t group = 0; group < directions.size(); ++group) {
    const auto [below, above] = beside[group];
    if (below != noGroup && above != noGroup)
      directions[group] = groups.centroids[above] - groups.centroids[below];
    directions[group].normalize();
  }
  std::vector<double> means(directions.size(), 0);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const std::uint32_t group = groups.ofPoint[i];
    if (group == noGroup) continue;
    const Eigen::Vector3d from =
        points.col(static_cast<Eigen::Index>(i)).cast<double>() - groups.centroids[group];
    means[group] +=
        (from - from.dot(directions[group]) * directions[group]).norm() / groups.sizes[group];
  }
  return means;
}

/// Draws wood thicker than `radius` [L] to its axis, by pieces of `length` [L].
void draw(Eigen::Matrix3Xf& points, Eigen::Index root, const ThickWoodOptions& options,
          double radius, double length, const Progress& progress) {
  const NeighborhoodGraph parts(points, options.neighbors, progress.part(0, 0.5));
  const float widestGap = options.widestGap > 0 ? static_cast<float>(options.widestGap)
                                                : std::numeric_limits<float>::max();
  const NeighborhoodGraph graph = joined(parts, points, widestGap, progress.part(0.5, 0.7));
  const GeodesicGroups groups = geodesicGroups(graph, points, root, length, progress.part(0.7, 1));
  std::vector<Beside> beside(groups.sizes.size());
  for (std::uint32_t group = 0; group < beside.size(); ++group)
    beside[group] = besideOf(groups, group);
  const std::vector<double> thick = thicknesses(groups, beside, points);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const std::uint32_t group = groups.ofPoint[i];
    if (group == noGroup || thick[group] <= radius) continue;
    const double bins = static_cast<double>(groups.distances[i]) / length;
    const double along = bins - groups.bins[group] - 0.5; // from the middle of its bin
    const std::uint32_t to = along < 0 ? beside[group].below : beside[group].above;
    Eigen::Vector3d place = groups.centroids[group];
    if (to != noGroup) place += std::abs(along) * (groups.centroids[to] - groups.centroids[group]);
    points.col(static_cast<Eigen::Index>(i)) = place.cast<float>();
  }
}

} // namespace

Eigen::Matrix3Xf withThickWoodAsLines(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                      const ThickWoodOptions& options, const Progress& progress) {
  Eigen::Matrix3Xf result = points;
  if (!(options.radius > 0)) return result;
  // Long pieces first: short ones would fall apart around thick wood, as long ones would take the
  // foot of a branch to that of another.
  draw(result, root, options, 3 * options.radius, 6 * options.radius, progress.part(0, 0.5));
  draw(result, root, options, options.radius, 3 * options.radius, progress.part(0.5, 1));
  return result;
}

} // namespace espalier
