#include "core/reconstruct/blade_midlines.h"

#include "core/cloud/point_cloud.h"
#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhood_graph.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr int bladeNeighbors = 8;
constexpr std::size_t fewestOfBlade = 12; // points that may be a blade

/// The points of each blade, those of the first point first.
std::vector<std::vector<Eigen::Index>> bladesAmong(const Eigen::Matrix3Xf& points, double link,
                                                   const Progress& progress) {
  const NeighborhoodGraph graph(points, bladeNeighbors, progress);
  std::vector<std::vector<Eigen::Index>> blades;
  std::vector<bool> isMet(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index first = 0; first < points.cols(); ++first) {
    if (isMet[static_cast<std::size_t>(first)]) continue;
    std::vector<Eigen::Index> blade = pointsLinkedTo(graph, first, static_cast<float>(link), isMet);
    if (blade.size() >= fewestOfBlade) blades.push_back(std::move(blade));
  }
  return blades;
}

/// Where a blade begins.
struct BladeBase {
  Eigen::Index point = 0; // of the blade
  NearestPlace bearer;
};

BladeBase baseOf(const Eigen::Matrix3Xf& blade, const Vector3d& origin, const EdgeIndex& wood) {
  std::optional<BladeBase> nearest;
  for (Eigen::Index i = 0; i < blade.cols(); ++i) {
    const NearestPlace place = *wood.nearest(blade.col(i).cast<double>() + origin);
    if (!nearest || place.distance < nearest->bearer.distance) nearest = {i, place};
  }
  return *nearest;
}

/// Means of bands of the distance from the base, one per step, without the base.
std::vector<Vector3d> bandsOf(const Eigen::Matrix3Xf& blade, const std::vector<float>& distances,
                              double longest, double step) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(longest / step)));
  std::vector<Vector3d> sums(count, Vector3d::Zero());
  std::vector<double> points(count, 0);
  for (Eigen::Index i = 0; i < blade.cols(); ++i) {
    const double share = static_cast<double>(distances[static_cast<std::size_t>(i)]) / longest;
    if (!(share > 0.5 / static_cast<double>(count)) || share > 1) continue; // at the base
    const auto band =
        std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count) - 0.5));
    sums[band] += blade.col(i).cast<double>();
    ++points[band];
  }
  std::vector<Vector3d> means;
  for (std::size_t band = 0; band < count; ++band)
    if (points[band] > 0) means.emplace_back(sums[band] / points[band]);
  return means;
}

/// From the base to the tip, without the base; empty if it is no blade.
std::vector<Vector3d> midlineOf(const Eigen::Matrix3Xf& blade, Eigen::Index base, double step,
                                double leastLength, const Progress& progress) {
  const NeighborhoodGraph graph(blade, bladeNeighbors);
  const std::vector<float> distances = geodesics(graph, {base}, 1, progress).distance;
  double longest = 0;
  Eigen::Index tip = base;
  for (Eigen::Index i = 0; i < blade.cols(); ++i) {
    const auto distance = static_cast<double>(distances[static_cast<std::size_t>(i)]);
    if (!std::isfinite(distance) || distance <= longest) continue;
    longest = distance;
    tip = i;
  }
  if (!(step > 0) || longest < leastLength) return {};
  std::vector<Vector3d> line = bandsOf(blade, distances, longest, step);
  if (!line.empty()) line.back() = blade.col(tip).cast<double>();
  return line;
}

} // namespace

Skeleton withMidlines(Skeleton skeleton, const Eigen::Matrix3Xd& blades,
                      const MidlineOptions& options, const Progress& progress) {
  progress.check();
  if (skeleton.isEmpty() || blades.cols() < bladeNeighbors) return skeleton;
  const Vector3d origin = blades.col(0);
  const Eigen::Matrix3Xf points = (blades.colwise() - origin).cast<float>();
  const EdgeIndex wood(skeleton);
  const double spacing = pointSpacing(points, progress.part(0, 0.1));
  const auto found = bladesAmong(points, options.link * spacing, progress.part(0.1, 0.3));
  for (std::size_t i = 0; i < found.size(); ++i) {
    progress.update(0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(found.size()));
    const Eigen::Matrix3Xf blade = points(Eigen::all, found[i]);
    const BladeBase base = baseOf(blade, origin, wood);
    if (base.bearer.distance > options.widestGap) continue;
    NodeId below = base.bearer.node;
    if (base.bearer.share < 0.5 && skeleton[below].parent) below = *skeleton[below].parent;
    EdgeType edge = EdgeType::branching;
    for (const Vector3d& place : midlineOf(blade, base.point, options.step * spacing,
                                           options.leastLength, progress.part(0, 0))) {
      below = skeleton.add({.position = origin + place, .parent = below, .edge = edge});
      edge = EdgeType::successor;
    }
  }
  progress.update(1);
  return skeleton;
}

} // namespace espalier
