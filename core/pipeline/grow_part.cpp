#include "core/pipeline/grow_part.h"

#include "core/base/error.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/plant_scale.h"
#include "core/reconstruct/trace.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// The options with each setting that a rule derives for a plant of scale `whole`, as far as it is
/// in range for one of scale `part`.
PipelineOptions fixedOptions(const PipelineOptions& options, const PlantScale& whole,
                             const PlantScale& part) {
  PipelineOptions result = options;
  result.leftOut = {}; // columns of another cloud
  for (const Step& step : pipelineSteps()) {
    const Method& method = chosenMethod(step, options);
    const std::vector<double> values = resolvedValues(step, method, options, whole);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto [least, most] = method.options[i].range(part);
      result.settings[step.name][method.options[i].name] =
          fixedAt(std::clamp(values[i], least, most));
    }
  }
  return result;
}

PointCloud partOf(const PointCloud& cloud, const std::vector<Eigen::Index>& points) {
  RawPoints raw;
  for (const Eigen::Index point : points)
    raw.positions.push_back(cloud.position(point));
  return PointCloud(std::move(raw));
}

} // namespace

double tubeRadius(const Skeleton& skeleton, const PointOnSkeleton& place) {
  const Node& child = skeleton[place.child];
  if (!child.parent) return child.radius;
  const double below = skeleton[*child.parent].radius;
  return below + place.fraction * (child.radius - below);
}

std::vector<PointByTube> pointsByTube(const Eigen::Matrix3Xf& points, const Eigen::Vector3d& origin,
                                      const Skeleton& skeleton, const Progress& progress) {
  std::vector<PointByTube> result;
  result.reserve(static_cast<std::size_t>(points.cols()));
  for (const PointOnSkeleton& place : assignPoints(points, origin, skeleton, progress))
    result.push_back({place.child, place.distance - tubeRadius(skeleton, place)});
  return result;
}

std::vector<Eigen::Index> freePoints(const Skeleton& skeleton, const PointCloud& cloud,
                                     const PointSet& leftOut, double tolerance,
                                     const std::vector<bool>& isAsFree, const Progress& progress) {
  const std::vector<PointByTube> places =
      pointsByTube(cloud.positions(), cloud.origin(), skeleton, progress);
  std::vector<Eigen::Index> points;
  for (const Eigen::Index point : others(leftOut | repeatedPoints(cloud, leftOut), cloud.size())) {
    const PointByTube& place = places[static_cast<std::size_t>(point)];
    const bool isOfFree = !isAsFree.empty() && isAsFree[indexOf(place.child)];
    if (isOfFree || place.distance > tolerance) points.push_back(point);
  }
  return points;
}

Skeleton grownPart(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                   const Eigen::Vector3d& root, const PlantScale& whole,
                   const PipelineOptions& options, const Progress& progress) {
  const auto own = std::make_shared<const PointCloud>(partOf(cloud, points));
  PipelineOptions fixed = fixedOptions(options, whole, scaleOf(*own, {}, options.up, progress));
  fixed.root = root;
  return *Pipeline().run(own, fixed, progress).skeleton;
}

Skeleton lineAlong(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                   const Eigen::Vector3d& start, double edge, const Progress& progress) {
  const auto own = std::make_shared<const PointCloud>(partOf(cloud, points));
  const TraceGraph graph(own, nullptr, progress.part(0, 0.8));
  const Eigen::Vector3d end = graph.farthestFrom(start);
  const Eigen::Vector3d otherEnd = graph.farthestFrom(end);
  const double length = (end - otherEnd).norm();
  Skeleton line;
  if (length == 0) return line;
  const Trace trace =
      graph
          .between({end}, {otherEnd}, {.step = std::min(edge, length / 2), .alternatives = 0},
                   progress.part(0.8, 1))
          .front();
  std::optional<NodeId> last;
  for (std::size_t i = 0; i < trace.places.size(); ++i)
    last = line.add({.position = trace.places[i], .radius = trace.radii[i], .parent = last});
  const double beside = meanDistance(cloud, points, line);
  for (const NodeId id : line.ids())
    if (line[id].radius == 0) line.setRadius(id, beside);
  return line;
}

double meanDistance(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                    const Skeleton& skeleton) {
  assert(!points.empty());
  if (skeleton.size() < 2) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const PointOnSkeleton& place :
       assignPoints(cloud.positions()(Eigen::all, points), cloud.origin(), skeleton))
    sum += place.distance;
  return sum / static_cast<double>(points.size());
}

Skeleton grownOrLine(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                     const Eigen::Vector3d& root, const PlantScale& whole,
                     const PipelineOptions& options, double edge, const Progress& progress) {
  constexpr std::size_t enough = 5; // nodes: what branches is not for a line
  Skeleton grown;
  try {
    grown = grownPart(cloud, points, root, whole, options, progress.part(0, 0.7));
  } catch (const Error&) { // it makes no plant of them: too few along it
  }
  if (grown.size() >= enough) return grown;
  Skeleton line = lineAlong(cloud, points, root, edge, progress.part(0.7, 1));
  return meanDistance(cloud, points, line) < meanDistance(cloud, points, grown) ? line : grown;
}

} // namespace espalier
