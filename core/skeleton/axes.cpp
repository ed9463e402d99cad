#include "core/skeleton/axes.h"

#include <Eigen/Geometry>

#include <cassert>
#include <cmath>

namespace espalier {
namespace {

int step(const Node& node) {
  return node.parent && node.edge == EdgeType::branching ? 1 : 0;
}

} // namespace

std::vector<int> orders(const Skeleton& skeleton) {
  std::vector<int> result(skeleton.idEnd(), -1);
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    result[indexOf(id)] = step(node) + (node.parent ? result[indexOf(*node.parent)] : 0);
  }
  return result;
}

int order(const Skeleton& skeleton, NodeId id) {
  int result = 0;
  for (std::optional<NodeId> at = id; at; at = skeleton[*at].parent)
    result += step(skeleton[*at]);
  return result;
}

std::vector<Axis> axes(const Skeleton& skeleton) {
  std::vector<Axis> result;
  for (const NodeId id : skeleton.ids()) {
    const std::optional<NodeId> parent = skeleton[id].parent;
    if (parent && nextOnAxis(skeleton, *parent) == id) continue;
    result.push_back(axisThrough(skeleton, id));
  }
  return result;
}

std::optional<NodeId> nextOnAxis(const Skeleton& skeleton, NodeId id) {
  const std::vector<NodeId>& children = skeleton.children(id); // successors first
  if (children.empty() || skeleton[children[0]].edge != EdgeType::successor) return std::nullopt;
  return children[0];
}

std::optional<NodeId> previousOnAxis(const Skeleton& skeleton, NodeId id) {
  const std::optional<NodeId>& parent = skeleton[id].parent;
  return parent && nextOnAxis(skeleton, *parent) == id ? parent : std::nullopt;
}

Axis axisThrough(const Skeleton& skeleton, NodeId id) {
  NodeId first = id;
  for (std::optional<NodeId> below = skeleton[id].parent;
       below && nextOnAxis(skeleton, *below) == first; below = skeleton[first].parent)
    first = *below;
  Axis axis;
  for (std::optional<NodeId> at = first; at; at = nextOnAxis(skeleton, *at))
    axis.push_back(*at);
  return axis;
}

double turnAt(const Skeleton& skeleton, NodeId id) {
  const auto next = nextOnAxis(skeleton, id);
  const auto parent = skeleton[id].parent;
  if (!next || !parent) return 0;
  const Eigen::Vector3d before = skeleton[id].position - skeleton[*parent].position;
  const Eigen::Vector3d after = skeleton[*next].position - skeleton[id].position;
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

double length(const Skeleton& skeleton, const Axis& axis) {
  assert(!axis.empty());
  double sum = 0;
  for (const NodeId id : axis) {
    const Node& node = skeleton[id];
    if (node.parent) sum += (node.position - skeleton[*node.parent].position).norm();
  }
  return sum;
}

} // namespace espalier
