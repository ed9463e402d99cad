#include "core/pipeline/grow_part.h"

#include "core/base/error.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/step_graph.h"
#include "core/reconstruct/trace.h"
#include "core/skeleton/frustum.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

namespace espalier {
namespace {

PointCloud partOf(const PointCloud& cloud, const std::vector<Eigen::Index>& points) {
  RawPoints raw;
  for (const Eigen::Index point : points)
    raw.positions.push_back(cloud.position(point));
  return PointCloud(std::move(raw));
}

} // namespace

double frustumRadius(const Skeleton& skeleton, const PointOnSkeleton& place) {
  const std::optional<Frustum> wood = frustumOf(skeleton, place.child);
  return wood ? wood->radiusAt(place.fraction) : skeleton[place.child].radius;
}

std::vector<PointByFrustum> pointsByFrustum(const Eigen::Matrix3Xf& points,
                                            const Eigen::Vector3d& origin, const Skeleton& skeleton,
                                            const Progress& progress) {
  std::vector<PointByFrustum> result;
  result.reserve(static_cast<std::size_t>(points.cols()));
  for (const PointOnSkeleton& place : assignPoints(points, origin, skeleton, progress))
    result.push_back({place.child, place.distance - frustumRadius(skeleton, place)});
  return result;
}

std::vector<Eigen::Index> freePoints(const Skeleton& skeleton, const PointCloud& cloud,
                                     const PointSet& leftOut, double tolerance,
                                     const std::vector<bool>& isAsFree, const Progress& progress) {
  const std::vector<PointByFrustum> places =
      pointsByFrustum(cloud.positions(), cloud.origin(), skeleton, progress);
  std::vector<Eigen::Index> points;
  for (const Eigen::Index point : others(leftOut | repeatedPoints(cloud, leftOut), cloud.size())) {
    const PointByFrustum& place = places[static_cast<std::size_t>(point)];
    const bool isOfFree = !isAsFree.empty() && isAsFree[indexOf(place.child)];
    if (isOfFree || place.distance > tolerance) points.push_back(point);
  }
  return points;
}

Skeleton grownPart(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                   const Eigen::Vector3d& root, const PlantScale& whole,
                   const PipelineOptions& options, const Progress& progress) {
  const auto own = std::make_shared<const PointCloud>(partOf(cloud, points));
  PipelineOptions ofPart = options;
  ofPart.leftOut = {}; // columns of another cloud
  ofPart.organs = {};
  ofPart.root = root;
  requireNearRoot(*own, ofPart);
  PipelineState state = cleanedState(own, ofPart, whole, progress.part(0, 0.1));
  requirePlant(keptPoints(state));
  state.root = rootPoint(state, ofPart, 0);
  runSteps(stepsBetween(StepResult::cleaned, StepResult::radii, ofPart, whole), state,
           progress.part(0.1, 1));
  return *state.skeleton;
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
  if (points.size() < fewestPoints) { // their course is that of chance
    const NodeId first = line.add({.position = end});
    line.add({.position = otherEnd, .parent = first});
    const double beside = meanDistance(cloud, points, line);
    for (const NodeId id : line.ids())
      line.setRadius(id, beside);
    return line;
  }
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
  if (points.size() < fewestPoints) return lineAlong(cloud, points, root, edge, progress);
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
