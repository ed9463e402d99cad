#include "core/evaluate/match/edit_comparison.h"

#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/segments.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t attributes = 3; // but direction, which is compared by its angle

/// A part of a plant, as costs see it.
struct Part {
  std::vector<Eigen::Vector3d> polyline; // [L]: the parent of the first node, if any, then all
  double length = 0;                     // [L]
  Eigen::Vector3d center = Eigen::Vector3d::Zero();    // [L], of the vertices
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // unit, from end to end; 0: it has none
  std::array<double, attributes> values{};             // length, mean radius, order
};

/// One plant in parts, parents before children.
struct Parts {
  std::vector<std::vector<NodeId>> nodes;
  ParentList parents;
  std::vector<Part> parts;
};

std::vector<std::vector<NodeId>> cut(const Skeleton& skeleton, EditUnit unit) {
  std::vector<std::vector<NodeId>> nodes;
  switch (unit) {
  case EditUnit::node:
    for (const NodeId id : skeleton.ids())
      nodes.push_back({id});
    break;
  case EditUnit::segment:
    for (Segment& segment : unbranchedSegments(skeleton))
      nodes.push_back(std::move(segment.nodes));
    break;
  case EditUnit::axis:
    nodes = axes(skeleton);
    break;
  }
  return nodes;
}

void measure(Part& part) {
  for (std::size_t i = 1; i < part.polyline.size(); ++i)
    part.length += (part.polyline[i] - part.polyline[i - 1]).norm();
  for (const Eigen::Vector3d& place : part.polyline)
    part.center += place / static_cast<double>(part.polyline.size());
  const Eigen::Vector3d chord = part.polyline.back() - part.polyline.front();
  if (chord.norm() > 0) part.direction = chord.normalized();
}

Parts partsOf(const Skeleton& skeleton, EditUnit unit) {
  Parts plant{.nodes = cut(skeleton, unit), .parents = {}, .parts = {}};
  std::vector<std::size_t> partOf(skeleton.idEnd());
  for (std::size_t p = 0; p < plant.nodes.size(); ++p)
    for (const NodeId id : plant.nodes[p])
      partOf[indexOf(id)] = p;
  const std::vector<int> orderOf = orders(skeleton);
  for (const std::vector<NodeId>& nodes : plant.nodes) {
    Part part;
    const std::optional<NodeId>& parent = skeleton[nodes.front()].parent;
    if (parent) part.polyline.push_back(skeleton[*parent].position);
    plant.parents.push_back(parent ? std::optional(partOf[indexOf(*parent)]) : std::nullopt);
    double radius = 0;
    for (const NodeId id : nodes) {
      part.polyline.push_back(skeleton[id].position);
      radius += skeleton[id].radius / static_cast<double>(nodes.size());
    }
    measure(part);
    part.values = {part.length, radius, static_cast<double>(orderOf[indexOf(nodes.front())])};
    plant.parts.push_back(std::move(part));
  }
  return plant;
}

/// One part in place of a path.
Part merged(const Parts& plant, std::span<const std::size_t> path) {
  Part whole;
  for (const std::size_t p : path) {
    const Part& part = plant.parts[p];
    // From the second on, a polyline begins where the part is attached: on the one before.
    const bool isFirst = p == path.front();
    whole.polyline.insert(whole.polyline.end(), part.polyline.begin() + (isFirst ? 0 : 1),
                          part.polyline.end());
    whole.values[1] += part.values[1] / static_cast<double>(path.size());
  }
  measure(whole);
  whole.values[0] = whole.length;
  whole.values[2] = plant.parts[path.front()].values[2];
  return whole;
}

class Costs {
public:
  Costs(const Parts& result, const Parts& reference, const EditOptions& options)
      : options_(options), weights_{options.lengthWeight, options.radiusWeight,
                                    options.orderWeight} {
    std::array<double, attributes> least{};
    std::array<double, attributes> most{};
    least.fill(std::numeric_limits<double>::infinity());
    most.fill(-std::numeric_limits<double>::infinity());
    for (const Parts* plant : {&result, &reference})
      for (const Part& part : plant->parts)
        for (std::size_t k = 0; k < attributes; ++k) {
          least[k] = std::min(least[k], part.values[k]);
          most[k] = std::max(most[k], part.values[k]);
        }
    for (std::size_t k = 0; k < attributes; ++k)
      range_[k] = most[k] - least[k];
    weight_ = options.directionWeight;
    for (const double weight : weights_)
      weight_ += weight;
  }

  [[nodiscard]] double alone(const Part& part) const { return isCounted() ? 1 : part.length; }

  [[nodiscard]] double substitution(const Part& a, const Part& b) const {
    switch (options_.cost) {
    case EditCost::topology:
      return 0;
    case EditCost::attributes:
      return 2 * difference(a, b); // as much as both alone where they differ in all
    case EditCost::length:
      return std::abs(a.length - b.length);
    case EditCost::place:
      return std::abs(a.length - b.length) + (a.center - b.center).norm();
    case EditCost::shape:
      return std::min(a.length + b.length, vertexHausdorff(a.polyline, b.polyline));
    }
    return 0;
  }

  /// A path of one plant by a part of the other.
  [[nodiscard]] double merge(const Parts& plant, std::span<const std::size_t> path,
                             const Part& other) const {
    const double joints = isJointCounted() ? static_cast<double>(path.size() - 1) : 0;
    if (options_.cost == EditCost::topology) return joints; // whatever they look like
    return joints + substitution(merged(plant, path), other);
  }

private:
  [[nodiscard]] bool isCounted() const { return !countsLength(options_.cost); }

  /// What branches off at the joint of two segments is removed, and counted, where they are merged:
  /// that alone makes one segment of them, and there is nothing left to count. One axis that bears
  /// another does not become one with it.
  [[nodiscard]] bool isJointCounted() const {
    return isCounted() && options_.unit == EditUnit::axis;
  }

  [[nodiscard]] double difference(const Part& a, const Part& b) const { // in [0, 1]
    if (weight_ <= 0) return 0;
    const double angle = std::atan2(a.direction.cross(b.direction).norm(), // exact where it is 0
                                    a.direction.dot(b.direction));
    const bool haveDirections = !a.direction.isZero() && !b.direction.isZero();
    double sum = haveDirections ? options_.directionWeight * angle / std::numbers::pi : 0;
    for (std::size_t k = 0; k < attributes; ++k)
      if (range_[k] > 0) sum += weights_[k] * std::abs(a.values[k] - b.values[k]) / range_[k];
    return sum / weight_;
  }

  const EditOptions& options_;
  std::array<double, attributes> weights_;
  std::array<double, attributes> range_{};
  double weight_ = 0; // of all
};

} // namespace

EditComparison editComparison(const Skeleton& result, const Skeleton& reference,
                              const EditOptions& options, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const Parts first = partsOf(result, options.unit);
  const Parts second = partsOf(reference, options.unit);
  const Costs costs(first, second, options);
  EditCosts edits{.removal = {},
                  .insertion = {},
                  .substitution =
                      [&](std::size_t i, std::size_t j) {
                        return costs.substitution(first.parts[i], second.parts[j]);
                      },
                  .merge = nullptr,
                  .split = nullptr,
                  .longestPath = options.longestPath};
  for (const Part& part : first.parts)
    edits.removal.push_back(costs.alone(part));
  for (const Part& part : second.parts)
    edits.insertion.push_back(costs.alone(part));
  if (options.mergesPaths) {
    edits.merge = [&](std::span<const std::size_t> path, std::size_t j) {
      return costs.merge(first, path, second.parts[j]);
    };
    edits.split = [&](std::size_t i, std::span<const std::size_t> path) {
      return costs.merge(second, path, first.parts[i]);
    };
  }
  EditComparison comparison;
  comparison.options = options;
  comparison.distance = editDistance(first.parents, second.parents, edits, progress);
  std::size_t found = 0; // of the reference
  for (const EditMatch& match : comparison.distance.matches) {
    comparison.matched += match.first.size();
    found += match.second.size();
  }
  comparison.removed = first.parts.size() - comparison.matched;
  comparison.inserted = second.parts.size() - found;
  comparison.result = first.nodes;
  comparison.reference = second.nodes;
  return comparison;
}

bool countsLength(EditCost cost) {
  return cost != EditCost::topology && cost != EditCost::attributes;
}

const std::vector<std::string>& editUnitNames() {
  static const std::vector<std::string> names{"node", "segment", "axis"};
  return names;
}

const std::vector<std::string>& editCostNames() {
  static const std::vector<std::string> names{"topology", "attributes", "length", "place", "shape"};
  return names;
}

} // namespace espalier
