#include "core/pipeline/regrow.h"

#include "core/base/error.h"
#include "core/graph/components.h"
#include "core/skeleton/assign_points.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

namespace espalier {
namespace {

constexpr int neighbors = 12;
constexpr std::size_t fewestPoints = 20; // that tell a branch from dust

std::string name(NodeId id) {
  return "node " + std::to_string(indexOf(id));
}

double tubeRadius(const Skeleton& skeleton, const PointOnSkeleton& place) {
  const Node& child = skeleton[place.child];
  if (!child.parent) return child.radius;
  const double below = skeleton[*child.parent].radius;
  return below + place.fraction * (child.radius - below);
}

/// The points that edges of the rest of the plant do not explain.
std::vector<Eigen::Index> freePoints(const Skeleton& skeleton, NodeId node, const PointCloud& cloud,
                                     double tolerance, const Progress& progress) {
  std::vector<bool> isCarried(skeleton.idEnd(), false);
  for (const NodeId id : downstream(skeleton, {node}))
    isCarried[indexOf(id)] = id != node;
  const std::vector<PointOnSkeleton> places =
      assignPoints(cloud.positions(), cloud.origin(), skeleton, 8, progress);
  std::vector<Eigen::Index> points;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (isCarried[indexOf(places[i].child)] ||
        places[i].distance > tubeRadius(skeleton, places[i]) + tolerance)
      points.push_back(static_cast<Eigen::Index>(i));
  return points;
}

/// The points that links of at most `longest` lead to, in order. (The nearest neighbors of points
/// that stand alone are far off.)
std::vector<Eigen::Index> reached(const NeighborhoodGraph& graph, Eigen::Index first,
                                  float longest) {
  std::vector<bool> isMet(static_cast<std::size_t>(graph.size()), false);
  std::vector<Eigen::Index> points = {first};
  isMet[static_cast<std::size_t>(first)] = true;
  for (std::size_t next = 0; next < points.size(); ++next)
    for (const NeighborhoodGraph::Link& link : graph.links(points[next])) {
      if (link.length > longest || isMet[link.to]) continue;
      isMet[link.to] = true;
      points.push_back(link.to);
    }
  std::ranges::sort(points);
  return points;
}

/// Those of the points that hang together with the one nearest to the node.
/// @throws Error if there is none near it, or they are too few
std::vector<Eigen::Index> pointsAt(const Skeleton& skeleton, NodeId node, const PointCloud& cloud,
                                   const std::vector<Eigen::Index>& points, double widestGap,
                                   const Progress& progress) {
  const Error nothing("no points around " + name(node) +
                      " are left by the rest of the plant: choose another node");
  if (points.size() < fewestPoints) throw nothing;
  const Eigen::Matrix3Xf positions = cloud.positions()(Eigen::all, points);
  const Eigen::Vector3f place = (skeleton[node].position - cloud.origin()).cast<float>();
  const Eigen::Index first = nearestPoint(positions, place);
  const double reach = 2 * skeleton[node].radius + widestGap + meanEdgeLength(skeleton);
  if (static_cast<double>((positions.col(first) - place).norm()) > reach) throw nothing;
  const NeighborhoodGraph parts(positions, neighbors, progress.part(0, 0.7));
  const auto gap = static_cast<float>(widestGap);
  std::vector<Eigen::Index> together;
  for (const Eigen::Index found :
       reached(joined(parts, positions, gap, progress.part(0.7, 1)), first, gap))
    together.push_back(points[static_cast<std::size_t>(found)]);
  if (together.size() < fewestPoints) throw nothing;
  return together;
}

/// The options with each setting that a rule derives for a plant of scale `whole`, as far as it is
/// in range for one of scale `part`.
PipelineOptions fixedOptions(const PipelineOptions& options, const PlantScale& whole,
                             const PlantScale& part) {
  PipelineOptions result = options;
  for (const Step& step : pipelineSteps()) {
    const auto choice = options.methods.find(step.name);
    const Method& method =
        choice == options.methods.end() ? step.methods.front() : methodNamed(step, choice->second);
    const std::vector<double> values = resolvedValues(step, method, options, whole);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto [least, most] = method.options[i].range(part);
      result.settings[step.name][method.options[i].name] = std::clamp(values[i], least, most);
    }
  }
  return result;
}

/// The grown skeleton, hung on a root that stands for the node.
Skeleton hungOn(const Node& node, const Skeleton& grown, double edge) {
  Skeleton part;
  const NodeId root = part.add({.position = node.position, .radius = node.radius});
  const NodeId foot = grown.roots().front();
  const bool isSame = (grown[foot].position - node.position).norm() < edge / 2;
  std::vector<NodeId> copies(grown.idEnd(), root);
  for (const NodeId id : grown.ids()) {
    if (id == foot && isSame) continue;
    Node copy = grown[id];
    if (node.radius > 0) copy.radius = std::min(copy.radius, node.radius);
    if (copy.parent)
      copy.parent = copies[indexOf(*copy.parent)];
    else
      copy.parent = root;
    copies[indexOf(id)] = part.add(copy);
  }
  return part;
}

} // namespace

Skeleton regrown(const Skeleton& skeleton, NodeId node,
                 const std::shared_ptr<const PointCloud>& cloud, const RegrowOptions& options,
                 const Progress& progress) {
  assert(skeleton.contains(node));
  const UpAxis up = options.pipeline.up;
  const PlantScale whole = {pointSpacing(cloud->positions()), plantHeight(cloud->positions(), up)};
  const double tolerance = options.tolerance > 0 ? options.tolerance : 3 * whole.spacing;
  const double widestGap = options.widestGap > 0 ? options.widestGap : 8 * whole.spacing;
  const std::vector<Eigen::Index> left =
      freePoints(skeleton, node, *cloud, tolerance, progress.part(0, 0.3));
  RawPoints raw;
  for (const Eigen::Index point :
       pointsAt(skeleton, node, *cloud, left, widestGap, progress.part(0.3, 0.5)))
    raw.positions.push_back(cloud->position(point));
  const auto own = std::make_shared<const PointCloud>(std::move(raw));
  const PlantScale part = {pointSpacing(own->positions()), plantHeight(own->positions(), up)};
  PipelineOptions fixed = fixedOptions(options.pipeline, whole, part);
  fixed.root = skeleton[node].position;
  const Reconstruction result = Pipeline().run(own, fixed, progress.part(0.5, 1));
  Skeleton grown = hungOn(skeleton[node], result.skeleton, meanEdgeLength(result.skeleton));
  if (grown.size() < 2)
    throw Error("nothing grows from " + name(node) +
                ": choose another node, or prune less in the pipeline");
  return grown;
}

} // namespace espalier
