#include "core/pipeline/grow_part.h"

#include "core/base/error.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/step_graph.h"
#include "core/reconstruct/leave_wood.h"
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

double usualTolerance(const PlantScale& whole) {
  return 3 * std::max(whole.spacing, whole.scatter);
}

std::vector<Eigen::Index> freePoints(const PointCloud& cloud, const PointSet& leftOut,
                                     const std::vector<PointOnSkeleton>& places,
                                     const std::vector<double>& bark,
                                     const std::vector<bool>& isAsFree) {
  std::vector<Eigen::Index> points;
  for (const Eigen::Index point : others(leftOut | repeatedPoints(cloud, leftOut), cloud.size())) {
    const PointOnSkeleton& place = places[static_cast<std::size_t>(point)];
    const std::size_t edge = indexOf(place.child);
    if (place.distance > bark[edge] || (!isAsFree.empty() && isAsFree[edge]))
      points.push_back(point);
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

Skeleton treeAlong(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                   const Eigen::Vector3d& start, double edge, TracedFrom from,
                   const Progress& progress) {
  constexpr int mostBranches = 50;
  constexpr double about = 3;    // spacings beside the wood: its points
  constexpr double shortest = 6; // spacings: what is shorter is noise more often than not
  const auto own = std::make_shared<const PointCloud>(partOf(cloud, points));
  const TraceGraph graph(own, nullptr, progress.part(0, 0.5));
  const Eigen::Vector3d first = from == TracedFrom::start ? start : graph.farthestFrom(start);
  const Eigen::Vector3d last = graph.farthestFrom(first);
  Skeleton tree;
  if (first == last) return tree;
  if (points.size() < fewestPoints) { // their course is that of chance
    const NodeId root = tree.add({.position = first});
    tree.add({.position = last, .parent = root});
    const double radius = meanDistance(cloud, points, tree);
    for (const NodeId id : tree.ids())
      tree.setRadius(id, radius);
    return tree;
  }
  const double step = std::min(edge, (first - last).norm() / 2);
  const Trace trace =
      graph.between({first}, {last}, {.step = step, .alternatives = 0}, progress.part(0.5, 0.6))
          .front();
  std::optional<NodeId> above;
  for (std::size_t i = 0; i < trace.places.size(); ++i)
    above = tree.add({.position = trace.places[i], .radius = trace.radii[i], .parent = above});
  const double beside = meanDistance(cloud, points, tree);
  const auto fillRadii = [&] {
    for (const NodeId id : tree.ids())
      if (tree[id].radius == 0) tree.setRadius(id, beside);
  };
  fillRadii();
  for (int i = 0; i < mostBranches && graph.spacing() > 0; ++i) {
    const auto wood = std::make_shared<const EdgeIndex>(bodiesOf(tree));
    const std::optional<Eigen::Vector3d> tip =
        graph.farthestFrom(*wood, about * graph.spacing(), shortest * graph.spacing());
    if (!tip) break;
    const Trace branch =
        graph
            .between({wood->nearest(*tip)->position, true}, {*tip},
                     {.step = step, .alternatives = 0, .wood = wood}, progress.part(0.6, 1))
            .front();
    SkeletonEditor editor(tree);
    addTrace(editor, branch);
    (void)editor.commit();
    fillRadii();
  }
  return tree;
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

Skeleton grownOrTraced(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                       const Eigen::Vector3d& root, const PlantScale& whole,
                       const PipelineOptions& options, double edge, const Progress& progress) {
  constexpr std::size_t most = 20'000; // points: more of them are a plant
  constexpr double clearly = 0.9;      // so much nearer, what the pipeline makes is better
  Skeleton grown;
  try {
    if (points.size() >= fewestPoints)
      grown = grownPart(cloud, points, root, whole, options, progress.part(0, 0.7));
  } catch (const Error&) { // it makes no plant of them: too few along it
  }
  if (points.size() > most && grown.size() > 1) return grown;
  Skeleton traced = treeAlong(cloud, points, root, edge, TracedFrom::end, progress.part(0.7, 1));
  const double ofGrown = meanDistance(cloud, points, grown);
  return ofGrown < clearly * meanDistance(cloud, points, traced) ? grown : traced;
}

} // namespace espalier
