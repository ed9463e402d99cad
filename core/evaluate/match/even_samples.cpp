#include "core/evaluate/match/even_samples.h"

#include "core/evaluate/match/comparable.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace espalier {
namespace {

/// Depth first: a node added within an edge does not change the order of what lies around it.
std::vector<NodeId> depthFirst(const Skeleton& skeleton) {
  std::vector<NodeId> order;
  order.reserve(skeleton.size());
  std::vector<NodeId> open = skeleton.roots();
  std::reverse(open.begin(), open.end());
  while (!open.empty()) {
    const NodeId id = open.back();
    open.pop_back();
    order.push_back(id);
    const std::vector<NodeId>& children = skeleton.children(id);
    open.insert(open.end(), children.rbegin(), children.rend());
  }
  return order;
}

} // namespace

std::vector<EvenSample> evenSamples(const Skeleton& skeleton, double step, std::size_t most) {
  assert(step > 0 && most > 0);
  const double total = totalLength(skeleton);
  std::vector<EvenSample> samples;
  if (total == 0) return samples;
  const double count = std::clamp(std::round(total / step), 1.0, static_cast<double>(most));
  const double stretch = total / count;
  samples.reserve(static_cast<std::size_t>(count));
  double passed = 0; // length of the edges before this one
  for (const NodeId id : depthFirst(skeleton)) {
    const Node& node = skeleton[id];
    if (!node.parent) continue;
    const Eigen::Vector3d start = skeleton[*node.parent].position;
    const double length = (node.position - start).norm();
    // Each sample is amid its stretch, so rounding of the sum cannot lose the last.
    for (;;) {
      const double at = (static_cast<double>(samples.size()) + 0.5) * stretch - passed;
      if (at >= length || static_cast<double>(samples.size()) >= count) break;
      samples.push_back({id, start + at / length * (node.position - start)});
    }
    passed += length;
  }
  return samples;
}

Eigen::Vector3d centroid(const std::vector<EvenSample>& samples) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const EvenSample& sample : samples)
    sum += sample.position;
  return sum / static_cast<double>(samples.size());
}

} // namespace espalier
