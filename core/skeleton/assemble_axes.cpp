#include "core/skeleton/assemble_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

/// Length of the edge to each node and of all that hangs on it, by id [L].
std::vector<double> carriedLengths(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<double> carried(skeleton.idEnd(), 0);
  for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
    const Node& node = skeleton[*id];
    if (!node.parent) continue;
    carried[indexOf(*id)] += (node.position - skeleton[*node.parent].position).norm();
    carried[indexOf(*node.parent)] += carried[indexOf(*id)];
  }
  return carried;
}

/// The child that carries most, of those of a node that has some.
NodeId heaviestChild(const std::vector<NodeId>& children, const std::vector<double>& carried) {
  return *std::min_element(children.begin(), children.end(), [&](NodeId a, NodeId b) {
    const double left = carried[indexOf(a)];
    const double right = carried[indexOf(b)];
    return left != right ? left > right : a < b;
  });
}

/// Angle between the ways into a node and out of it to a child, over some edges [rad].
double turn(const Skeleton& skeleton, NodeId child, const std::vector<double>& carried, int reach) {
  const NodeId node = *skeleton[child].parent;
  NodeId before = node;
  for (int i = 0; i < reach && skeleton[before].parent; ++i)
    before = *skeleton[before].parent;
  NodeId behind = child;
  for (int i = 1; i < reach && !skeleton.children(behind).empty(); ++i)
    behind = heaviestChild(skeleton.children(behind), carried);
  const Eigen::Vector3d in = skeleton[node].position - skeleton[before].position;
  const Eigen::Vector3d out = skeleton[behind].position - skeleton[node].position;
  return std::atan2(in.cross(out).norm(), in.dot(out)); // 0 at a root
}

} // namespace

Skeleton withAssembledAxes(const Skeleton& skeleton, const AxisOptions& options) {
  Skeleton result = skeleton;
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<double> carried = carriedLengths(skeleton, ids);
  for (const NodeId id : ids) {
    const std::vector<NodeId>& children = skeleton.children(id);
    if (children.empty()) continue;
    const NodeId heaviest = heaviestChild(children, carried);
    for (const NodeId child : children) {
      const bool continues = child == heaviest &&
                             turn(skeleton, child, carried, options.reach) <= options.sharpestTurn;
      const EdgeType edge = continues ? EdgeType::successor : EdgeType::branching;
      if (skeleton[child].edge != edge) result.setEdge(child, edge);
    }
  }
  return result;
}

} // namespace espalier
