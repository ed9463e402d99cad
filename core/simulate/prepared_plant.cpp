#include "core/simulate/prepared_plant.h"

#include "core/base/error.h"
#include "core/simulate/grown_radii.h"
#include "core/skeleton/length_along.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// The node that goes on with the axis, if any.
std::optional<NodeId> successor(const Skeleton& plant, NodeId id) {
  const std::vector<NodeId>& children = plant.children(id);
  if (children.empty() || plant[children.front()].edge != EdgeType::successor) return std::nullopt;
  return children.front();
}

void check(const Skeleton& plant, const PreparationOptions& options) {
  for (const NodeId id : plant.ids())
    if (!plant[id].position.allFinite() || !std::isfinite(plant[id].radius))
      throw Error(nameOf(id) + ": its position or radius is not finite; correct or delete it");
  if (!(options.spacing >= 0) || options.smoothing < 0 || options.smoothing > 100)
    throw Error("preparation: expected a spacing of 0 or more and 0 to 100 smoothing passes");
  if (!(options.baseRadius >= 0) || !(options.apexRadius >= 0))
    throw Error("preparation: expected radii of 0 or more");
  if (!(options.apexExtension.value_or(0) >= 0) || std::isinf(options.apexExtension.value_or(0)))
    throw Error("preparation: expected an apex extension of 0 or more");
}

double medianOf(std::vector<double> values) { // pre: not empty
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double heightOf(const Skeleton& plant) {
  Eigen::AlignedBox3d box;
  for (const NodeId id : plant.ids())
    box.extend(plant[id].position);
  return box.sizes().z() > 0 ? box.sizes().z() : box.sizes().maxCoeff();
}

/// Each node drawn halfway to the chord between its neighbors on the axis, where its own place
/// along the axis is: spacing, however uneven, stays.
Skeleton smoothed(const Skeleton& plant) {
  Skeleton result = plant;
  for (const NodeId id : plant.ids()) {
    const std::optional<NodeId> next = successor(plant, id);
    if (!plant[id].parent || !next) continue;
    const double before = edgeLength(plant, id);
    const double after = edgeLength(plant, *next);
    if (before + after == 0) continue;
    const Vector3d& from = plant[*plant[id].parent].position;
    const Vector3d onChord = from + before / (before + after) * (plant[*next].position - from);
    result.setPosition(id, 0.5 * (plant[id].position + onChord));
  }
  return result;
}

Skeleton extended(Skeleton plant, double length) {
  for (const NodeId id : plant.ids()) {
    if (!plant.children(id).empty() || !plant[id].parent) continue;
    const Vector3d& end = plant[id].position;
    const Vector3d along = (end - plant[*plant[id].parent].position).normalized(); // or 0
    plant.setPosition(id, end + length * along);
  }
  return plant;
}

Skeleton withMissingRadii(Skeleton plant, const PreparationOptions& options) {
  const std::vector<NodeId> ids = plant.ids();
  if (std::all_of(ids.begin(), ids.end(), [&](NodeId id) { return plant[id].radius > 0; }))
    return plant;
  const double height = heightOf(plant);
  const Skeleton model = withGrownRadii(
      plant, {.baseRadius = options.baseRadius > 0 ? options.baseRadius : height / 100,
              .apexRadius = options.apexRadius > 0 ? options.apexRadius : height / 1500});
  std::vector<double> ratios;
  for (const NodeId id : ids)
    if (plant[id].radius > 0) ratios.push_back(plant[id].radius / model[id].radius);
  const double ratio = ratios.empty() ? 1 : medianOf(std::move(ratios));
  for (const NodeId id : ids)
    if (!(plant[id].radius > 0)) plant.setRadius(id, ratio * model[id].radius);
  return plant;
}

/// Direction of an axis where it goes on from one edge to the next: that of the parabola through
/// the three nodes. None if either edge has no length.
std::optional<Vector3d> tangentBetween(const Vector3d& before, const Vector3d& after) {
  const double b = before.norm();
  const double a = after.norm();
  if (a == 0 || b == 0) return std::nullopt;
  return (a / b * before + b / a * after) / (a + b);
}

/// The cubic curve along the edge of a node to its parent.
struct EdgeCurve {
  EdgeCurve(const Skeleton& plant, NodeId id)
      : from(plant[*plant[id].parent].position), to(plant[id].position),
        length((to - from).norm()) {
    if (length == 0) return;
    const NodeId parent = *plant[id].parent;
    std::optional<Vector3d> first;
    std::optional<Vector3d> last;
    if (plant[parent].parent && successor(plant, parent) == id)
      first = tangentBetween(from - plant[*plant[parent].parent].position, to - from);
    if (const std::optional<NodeId> next = successor(plant, id))
      last = tangentBetween(to - from, plant[*next].position - to);
    // At an end of an axis the parabola goes on.
    const Vector3d chord = (to - from) / length;
    leaving = first ? *first : last ? Vector3d(2 * chord - *last) : chord;
    arriving = last ? *last : Vector3d(2 * chord - leaving);
  }

  [[nodiscard]] Vector3d at(double t) const {
    const double s = 1 - t;
    return s * s * (1 + 2 * t) * from + t * t * (3 - 2 * t) * to +
           length * t * s * (s * leaving - t * arriving);
  }

  Vector3d from;
  Vector3d to;
  double length;
  Vector3d leaving = Vector3d::Zero();
  Vector3d arriving = Vector3d::Zero();
};

Skeleton resampled(const Skeleton& plant, double spacing) {
  Skeleton result;
  std::vector<NodeId> copies(plant.idEnd());
  for (const NodeId id : plant.ids()) {
    Node node = plant[id];
    if (!node.parent) {
      copies[indexOf(id)] = result.add(node);
      continue;
    }
    const EdgeCurve curve(plant, id);
    const bool branches = node.edge == EdgeType::branching;
    const double fromRadius = branches ? node.radius : plant[*node.parent].radius;
    const double toRadius = node.radius;
    const double pieces = std::max(1.0, std::ceil(curve.length / spacing));
    NodeId last = copies[indexOf(*node.parent)];
    for (double i = 1; i <= pieces; ++i) {
      const double t = i / pieces;
      node.position = i < pieces ? curve.at(t) : curve.to;
      node.radius = fromRadius + t * (toRadius - fromRadius);
      node.parent = last;
      node.edge = i == 1 ? plant[id].edge : EdgeType::successor;
      last = result.add(node);
    }
    copies[indexOf(id)] = last;
  }
  return result;
}

} // namespace

Skeleton preparedPlant(const Skeleton& structure, const PreparationOptions& options) {
  check(structure, options);
  std::vector<double> lengths;
  double total = 0;
  for (const NodeId id : structure.ids()) {
    if (!structure[id].parent) continue;
    lengths.push_back(edgeLength(structure, id));
    total += lengths.back();
  }
  if (!(total > 0)) return structure;
  const double mean = total / static_cast<double>(lengths.size());
  const double median = medianOf(std::move(lengths));
  const double common = median > 0 ? median : mean; // 0: over half of the edges have no length
  const double spacing = options.spacing > 0 ? options.spacing : common / 3;
  if (total / spacing > 1e7)
    throw Error("preparation: so small a spacing gives over 10^7 nodes; try a larger one");
  Skeleton plant = structure;
  for (int pass = 0; pass < options.smoothing; ++pass)
    plant = smoothed(plant);
  plant = extended(std::move(plant), options.apexExtension.value_or(common / 2));
  return resampled(withMissingRadii(std::move(plant), options), spacing);
}

} // namespace espalier
