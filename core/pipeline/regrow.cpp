#include "core/pipeline/regrow.h"

#include "core/base/shown_message.h"
#include "core/base/spatial_index.h"
#include "core/graph/components.h"
#include "core/pipeline/attach_grown.h"
#include "core/pipeline/grow_part.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/wood_skin.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace espalier {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// By id: what `node` carries.
std::vector<bool> carriedBy(const Skeleton& skeleton, NodeId node) {
  std::vector<bool> isCarried(skeleton.idEnd(), false);
  for (const NodeId id : downstream(skeleton, {node}))
    isCarried[indexOf(id)] = id != node;
  return isCarried;
}

/// A node with what it carries, by itself.
Skeleton partOf(const Skeleton& skeleton, NodeId node) {
  Skeleton part;
  std::vector<NodeId> copies(skeleton.idEnd());
  for (const NodeId id : downstream(skeleton, {node})) {
    Node copy = skeleton[id];
    if (id == node)
      copy.parent.reset();
    else
      copy.parent = copies[indexOf(*copy.parent)];
    copies[indexOf(id)] = part.add(copy);
  }
  return part;
}

bool isUnbranched(const Skeleton& skeleton) {
  return std::ranges::all_of(skeleton.ids(),
                             [&](NodeId id) { return skeleton.children(id).size() <= 1; });
}

/// Those of the points that are connected with the one nearest to the node.
/// @param reach [L] from the node to that point, at most
/// @throws Error if there is none, or they are too few
std::vector<Eigen::Index> pointsAt(const Skeleton& skeleton, NodeId node, const PointCloud& cloud,
                                   const std::vector<Eigen::Index>& points, double reach,
                                   double widestGap, const Progress& progress) {
  const ShownError nothing(
      {Shown::tr("no points around node %1 are left by the rest of the plant: choose another node"),
       {std::to_string(indexOf(node))}});
  if (points.size() < fewestChosen) throw ShownError(nothing);
  const Eigen::Matrix3Xf positions = cloud.positions()(Eigen::all, points);
  const Eigen::Vector3f place = (skeleton[node].position - cloud.origin()).cast<float>();
  const Eigen::Index first = nearestPoint(positions, place);
  if (static_cast<double>((positions.col(first) - place).norm()) > reach) throw ShownError(nothing);
  const NeighborhoodGraph parts(positions, partLinks, progress.part(0, 0.7));
  const auto gap = static_cast<float>(widestGap);
  std::vector<Eigen::Index> together;
  std::vector<bool> isMet(points.size(), false);
  for (const Eigen::Index found :
       pointsLinkedTo(joined(parts, positions, gap, progress.part(0.7, 1)), first, gap, isMet))
    together.push_back(points[static_cast<std::size_t>(found)]);
  if (together.size() < fewestChosen) throw ShownError(nothing);
  return together;
}

} // namespace

Skeleton regrown(const Skeleton& skeleton, NodeId node,
                 const std::shared_ptr<const PointCloud>& cloud, const RegrowOptions& wanted,
                 const Progress& progress) {
  assert(skeleton.contains(node));
  RegrowOptions options = wanted;
  options.pipeline = withScanCleaned(cloud, wanted.pipeline, progress.part(0, 0));
  const PlantScale whole = scaleOf(*cloud, options.pipeline.leftOut, options.pipeline.up, progress);
  const double tolerance = options.tolerance > 0 ? options.tolerance : usualTolerance(whole);
  const double widestGap = options.widestGap > 0 ? options.widestGap : 8 * whole.spacing;
  const std::vector<bool> isCarried = carriedBy(skeleton, node);
  const std::vector<PointOnSkeleton> places =
      assignPoints(cloud->positions(), cloud->origin(), skeleton, progress.part(0, 0.3));
  std::vector<double> bark = barkReaches(skeleton, places, tolerance);
  progress.check();
  bark[indexOf(node)] = std::min(bark[indexOf(node)], skeleton[node].radius + tolerance); // begins
  const std::vector<Eigen::Index> left =
      freePoints(*cloud, options.pipeline.leftOut, places, bark, isCarried);
  const double reach = 2 * skeleton[node].radius + widestGap + meanEdgeLength(skeleton);
  const std::vector<Eigen::Index> points =
      pointsAt(skeleton, node, *cloud, left, reach, widestGap, progress.part(0.3, 0.5));
  const Skeleton before = partOf(skeleton, node);
  const bool isChain = before.size() > 1 && isUnbranched(before);
  const double mean = meanEdgeLength(isChain ? before : skeleton);
  const double edge = mean > 0 ? mean : 9 * whole.spacing;
  const Eigen::Vector3d& foot = skeleton[node].position;
  std::vector<Skeleton> candidates = {
      grownOrTraced(*cloud, points, foot, whole, options.pipeline, edge, progress.part(0.5, 0.9))};
  if (isChain)
    candidates.push_back(
        treeAlong(*cloud, points, foot, edge, TracedFrom::start, progress.part(0.9, 0.95)));
  const AttachOptions attach{.spacing = whole.spacing, .widestGap = widestGap, .widestJoin = reach};
  Skeleton best;
  double least = unbounded;
  for (const Skeleton& candidate : candidates) {
    if (candidate.isEmpty()) continue;
    const auto branches =
        attached(skeleton, {node}, candidate, *cloud, attach, progress.part(0.95, 1));
    const double distance =
        branches.empty() ? unbounded : meanDistance(*cloud, points, branches.front().part);
    if (distance >= least) continue;
    least = distance;
    best = branches.front().part;
  }
  if (best.isEmpty())
    throw ShownError(
        {Shown::tr(
             "nothing grows from node %1: choose another node, or prune less in the pipeline"),
         {std::to_string(indexOf(node))}});
  const double slight = 0.25 * whole.spacing; // less is chance
  if (isChain && least > meanDistance(*cloud, points, before) + slight)
    throw ShownError({Shown::tr("what node %1 carries follows the points better than what would "
                                "grow: it stays as it is"),
                      {std::to_string(indexOf(node))}});
  return best;
}

} // namespace espalier
