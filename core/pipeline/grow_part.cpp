#include "core/pipeline/grow_part.h"

#include "core/skeleton/assign_points.h"
#include "core/skeleton/path_edits.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace espalier {
namespace {

double tubeRadius(const Skeleton& skeleton, const PointOnSkeleton& place) {
  const Node& child = skeleton[place.child];
  if (!child.parent) return child.radius;
  const double below = skeleton[*child.parent].radius;
  return below + place.fraction * (child.radius - below);
}

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

} // namespace

std::vector<PointByTube> pointsByTube(const Eigen::Matrix3Xf& points, const Eigen::Vector3d& origin,
                                      const Skeleton& skeleton, const Progress& progress) {
  std::vector<PointByTube> result;
  result.reserve(static_cast<std::size_t>(points.cols()));
  for (const PointOnSkeleton& place : assignPoints(points, origin, skeleton, 8, progress))
    result.push_back({place.child, place.distance - tubeRadius(skeleton, place)});
  return result;
}

std::vector<Eigen::Index> freePoints(const Skeleton& skeleton, const PointCloud& cloud,
                                     const PointSet& leftOut, double tolerance,
                                     const std::vector<bool>& isAsFree, const Progress& progress) {
  const std::vector<PointByTube> places =
      pointsByTube(cloud.positions(), cloud.origin(), skeleton, progress);
  std::vector<Eigen::Index> points;
  for (const Eigen::Index point : others(leftOut, cloud.size())) {
    const PointByTube& place = places[static_cast<std::size_t>(point)];
    const bool isOfFree = !isAsFree.empty() && isAsFree[indexOf(place.child)];
    if (isOfFree || place.distance > tolerance) points.push_back(point);
  }
  return points;
}

PlantScale scaleOf(const PointCloud& cloud, UpAxis up) {
  return {pointSpacing(cloud.positions()), plantHeight(cloud.positions(), up)};
}

Skeleton grownPart(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                   const Eigen::Vector3d& root, const PlantScale& whole,
                   const PipelineOptions& options, const Progress& progress) {
  RawPoints raw;
  for (const Eigen::Index point : points)
    raw.positions.push_back(cloud.position(point));
  const auto own = std::make_shared<const PointCloud>(std::move(raw));
  PipelineOptions fixed = fixedOptions(options, whole, scaleOf(*own, options.up));
  fixed.root = root;
  return *Pipeline().run(own, fixed, progress).skeleton;
}

Skeleton hungOn(const Node& node, const Skeleton& grown) {
  Skeleton part;
  const NodeId root = part.add({.position = node.position, .radius = node.radius});
  const NodeId foot = grown.roots().front();
  const bool isSame = (grown[foot].position - node.position).norm() < meanEdgeLength(grown) / 2;
  std::vector<NodeId> copies(grown.idEnd(), root);
  for (const NodeId id : grown.ids()) {
    if (id == foot && isSame) continue;
    Node copy = grown[id];
    if (node.radius > 0) copy.radius = std::min(copy.radius, node.radius);
    copy.parent = copy.parent ? copies[indexOf(*copy.parent)] : root;
    copies[indexOf(id)] = part.add(copy);
  }
  return part;
}

} // namespace espalier
