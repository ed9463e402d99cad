#include "core/evaluate/traits.h"

#include "core/evaluate/comparable.h"
#include "core/evaluate/segments.h"

#include <Eigen/Geometry>

namespace espalier {
namespace {

bool isTip(const Skeleton& skeleton, NodeId id) {
  return skeleton[id].parent && skeleton.children(id).empty();
}

bool isBranching(const Skeleton& skeleton, NodeId id) {
  return skeleton.children(id).size() > 1;
}

/// Positions of the nodes that `isWanted`.
template <class IsWanted>
std::vector<Eigen::Vector3d> positions(const Skeleton& skeleton, const IsWanted& isWanted) {
  std::vector<Eigen::Vector3d> result;
  for (const NodeId id : skeleton.ids())
    if (isWanted(skeleton, id)) result.push_back(skeleton[id].position);
  return result;
}

bool startsAxis(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  return !node.parent || node.edge == EdgeType::branching ||
         skeleton.children(*node.parent).front() != id; // successors come first
}

void countByOrder(const Skeleton& skeleton, Traits& traits) {
  std::vector<std::size_t> orderOf(skeleton.idEnd(), 0);
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    std::size_t& order = orderOf[indexOf(id)];
    if (node.parent)
      order = orderOf[indexOf(*node.parent)] + (node.edge == EdgeType::branching ? 1 : 0);
    if (order >= traits.axesByOrder.size()) {
      traits.axesByOrder.resize(order + 1, 0);
      traits.lengthByOrder.resize(order + 1, 0);
    }
    if (startsAxis(skeleton, id)) ++traits.axesByOrder[order];
    if (node.parent)
      traits.lengthByOrder[order] += (node.position - skeleton[*node.parent].position).norm();
  }
}

} // namespace

Traits traits(const Skeleton& skeleton) {
  Traits result;
  result.nodes = skeleton.size();
  result.roots = skeleton.roots().size();
  result.tips = tips(skeleton).size();
  result.branchings = branchings(skeleton).size();
  result.segments = unbranchedSegments(skeleton).size();
  result.length = totalLength(skeleton);
  result.medianEdge = medianEdgeLength(skeleton);
  if (!skeleton.isEmpty()) result.extent = bounds(skeleton).sizes();
  countByOrder(skeleton, result);
  return result;
}

std::vector<Eigen::Vector3d> tips(const Skeleton& skeleton) {
  return positions(skeleton, isTip);
}

std::vector<Eigen::Vector3d> branchings(const Skeleton& skeleton) {
  return positions(skeleton, isBranching);
}

} // namespace espalier
