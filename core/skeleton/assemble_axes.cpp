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

double turn(const Skeleton& skeleton, NodeId child) {
  const Node& node = skeleton[*skeleton[child].parent];
  if (!node.parent) return 0;
  const Eigen::Vector3d in = node.position - skeleton[*node.parent].position;
  const Eigen::Vector3d out = skeleton[child].position - node.position;
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

} // namespace

Skeleton withAssembledAxes(const Skeleton& skeleton, const AxisOptions& options) {
  Skeleton result = skeleton;
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<double> carried = carriedLengths(skeleton, ids);
  for (const NodeId id : ids) {
    const std::vector<NodeId>& children = skeleton.children(id);
    if (children.empty()) continue;
    const NodeId heaviest =
        *std::min_element(children.begin(), children.end(), [&](NodeId a, NodeId b) {
          const double left = carried[indexOf(a)];
          const double right = carried[indexOf(b)];
          return left != right ? left > right : a < b;
        });
    for (const NodeId child : children) {
      const bool continues = child == heaviest && turn(skeleton, child) <= options.sharpestTurn;
      result.setEdge(child, continues ? EdgeType::successor : EdgeType::branching);
    }
  }
  return result;
}

} // namespace espalier
