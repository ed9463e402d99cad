#include "core/evaluate/traits/traits.h"

#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/segments.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/bounds.h"

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

void countByOrder(const Skeleton& skeleton, Traits& traits) {
  const std::vector<int> orderOf = orders(skeleton);
  for (const Axis& axis : axes(skeleton)) {
    const auto order = static_cast<std::size_t>(orderOf[indexOf(axis.front())]);
    if (order >= traits.axesByOrder.size()) {
      traits.axesByOrder.resize(order + 1, 0);
      traits.lengthByOrder.resize(order + 1, 0);
    }
    ++traits.axesByOrder[order];
    traits.lengthByOrder[order] += length(skeleton, axis);
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
  result.axes = axisTraits(skeleton);
  result.stem = stemTraits(skeleton);
  result.strahler = strahlerOrders(skeleton);
  result.angles = branchAngles(skeleton);
  result.crown = crownDimensions(skeleton);
  return result;
}

std::vector<Eigen::Vector3d> tips(const Skeleton& skeleton) {
  return positions(skeleton, isTip);
}

std::vector<Eigen::Vector3d> branchings(const Skeleton& skeleton) {
  return positions(skeleton, isBranching);
}

} // namespace espalier
