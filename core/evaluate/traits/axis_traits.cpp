#include "core/evaluate/traits/axis_traits.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

/// How far along its axis each node is, by id, with the edge that attaches the axis [L].
std::vector<double> lengthsAlong(const Skeleton& skeleton, const std::vector<Axis>& all) {
  std::vector<double> along(skeleton.idEnd(), 0);
  for (const Axis& axis : all) {
    double passed = 0;
    for (const NodeId id : axis) {
      if (const auto parent = skeleton[id].parent)
        passed += (skeleton[id].position - skeleton[*parent].position).norm();
      along[indexOf(id)] = passed;
    }
  }
  return along;
}

/// A mean that grows.
struct Mean {
  double sum = 0;
  std::size_t count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  [[nodiscard]] double value() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
};

/// What is gathered of the axes of one order.
struct AxisSums {
  std::vector<double> lengths;
  Mean chord;
  Mean insertion;
  Mean baseRadius;
  Mean topRadius;
};

AxisTraits traitsOf(AxisSums sums) {
  AxisTraits traits{.count = sums.lengths.size()};
  Mean length;
  for (const double each : sums.lengths)
    length.add(each);
  traits.meanLength = length.value();
  double squares = 0;
  for (const double each : sums.lengths)
    squares += std::pow(each - traits.meanLength, 2);
  if (traits.count > 1)
    traits.lengthDeviation = std::sqrt(squares / static_cast<double>(traits.count - 1));
  std::ranges::sort(sums.lengths);
  const std::size_t half = traits.count / 2;
  if (traits.count > 0)
    traits.medianLength = traits.count % 2 == 1 ? sums.lengths[half]
                                                : (sums.lengths[half - 1] + sums.lengths[half]) / 2;
  traits.meanChord = sums.chord.value();
  traits.meanInsertion = sums.insertion.value();
  traits.meanBaseRadius = sums.baseRadius.value();
  traits.meanTopRadius = sums.topRadius.value();
  return traits;
}

} // namespace

std::vector<AxisTraits> axisTraits(const Skeleton& skeleton) {
  const std::vector<Axis> all = axes(skeleton);
  const std::vector<int> orderOf = orders(skeleton);
  const std::vector<double> along = lengthsAlong(skeleton, all);
  std::vector<double> lengths(skeleton.idEnd(), 0); // of the axis of each node
  for (const Axis& axis : all)
    for (const NodeId id : axis)
      lengths[indexOf(id)] = along[indexOf(axis.back())];
  std::vector<AxisSums> sums;
  for (const Axis& axis : all) {
    const auto order = static_cast<std::size_t>(orderOf[indexOf(axis.front())]);
    if (order >= sums.size()) sums.resize(order + 1);
    AxisSums& of = sums[order];
    const Node& first = skeleton[axis.front()];
    const Node& last = skeleton[axis.back()];
    const Eigen::Vector3d& foot = first.parent ? skeleton[*first.parent].position : first.position;
    of.lengths.push_back(along[indexOf(axis.back())]);
    of.chord.add((last.position - foot).norm());
    if (first.radius > 0) of.baseRadius.add(first.radius);
    if (last.radius > 0) of.topRadius.add(last.radius);
    if (!first.parent || !(lengths[indexOf(*first.parent)] > 0)) continue;
    of.insertion.add(along[indexOf(*first.parent)] / lengths[indexOf(*first.parent)]);
  }
  std::vector<AxisTraits> traits;
  traits.reserve(sums.size());
  for (AxisSums& each : sums)
    traits.push_back(traitsOf(std::move(each)));
  return traits;
}

StemTraits stemTraits(const Skeleton& skeleton) {
  const Axis stem = stemOf(skeleton);
  StemTraits traits;
  if (stem.empty()) return traits;
  std::optional<double> lowest;
  for (std::size_t i = 0; i < stem.size(); ++i) {
    if (i > 0)
      traits.length += (skeleton[stem[i]].position - skeleton[stem[i - 1]].position).norm();
    const std::size_t onStem = i + 1 < stem.size() ? 1 : 0;
    if (skeleton.children(stem[i]).size() == onStem) continue;
    if (!lowest) lowest = traits.length;
    traits.highestBranch = traits.length;
  }
  traits.lowestBranch = lowest.value_or(0);
  traits.baseRadius = skeleton[stem.front()].radius;
  traits.topRadius = skeleton[stem.back()].radius;
  return traits;
}

Axis stemOf(const Skeleton& skeleton) {
  std::vector<NodeId> rootOf(skeleton.idEnd());
  std::vector<double> lengthOf(skeleton.idEnd(), 0); // of its tree, by root
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    rootOf[indexOf(id)] = node.parent ? rootOf[indexOf(*node.parent)] : id;
    if (node.parent)
      lengthOf[indexOf(rootOf[indexOf(id)])] +=
          (node.position - skeleton[*node.parent].position).norm();
  }
  const std::vector<NodeId> roots = skeleton.roots();
  const auto longest =
      std::ranges::max_element(roots, {}, [&](NodeId root) { return lengthOf[indexOf(root)]; });
  return longest != roots.end() ? axisThrough(skeleton, *longest) : Axis();
}

} // namespace espalier
