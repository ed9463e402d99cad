#include "core/skeleton/unseen_wood.h"

#include "core/skeleton/axes.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <set>

namespace espalier {

UnseenWood::UnseenWood(const Skeleton& skeleton, const PointDistances& distances,
                       const SpatialIndex& index, double spacing, const CheckOptions& options)
    : skeleton_(skeleton), options_(options), own_(skeleton, distances, index, spacing, options),
      expected_(skeleton, distances, options.ownReach * spacing) {}

bool UnseenWood::mayBeHidden(const Finding& finding) const {
  if (finding.amount * expected_.perLength(nodesOf(finding)) < options_.fewestExpected) return true;
  return finding.kind == Finding::Kind::edgesWithoutPoints && goesOn(finding);
}

bool UnseenWood::goesOn(const Finding& finding) const {
  if (turns(finding.node)) return false;
  const std::vector<NodeId> nodes = nodesOf(finding);
  const std::set<NodeId> stretch(nodes.begin(), nodes.end());
  bool isEnd = true;
  for (const NodeId id : stretch)
    for (const NodeId child : skeleton_.children(id)) {
      if (stretch.contains(child)) continue;
      isEnd = false;
      if (nextOnAxis(skeleton_, id) == child && turns(child)) return false;
    }
  return !isEnd || isSeenBefore(finding);
}

bool UnseenWood::turns(NodeId id) const {
  const auto parent = skeleton_[id].parent;
  if (!parent || nextOnAxis(skeleton_, *parent) != id || !skeleton_[*parent].parent) return true;
  return turnAt(skeleton_, *parent) > options_.hiddenTurn;
}

/// Whether the axis has points of its own before it goes on without, and is as long there.
bool UnseenWood::isSeenBefore(const Finding& finding) const {
  std::vector<NodeId> before;
  double length = 0;
  for (auto at = previousOnAxis(skeleton_, finding.node); at && skeleton_[*at].parent;
       at = previousOnAxis(skeleton_, *at)) {
    before.push_back(*at);
    length += edgeLength(skeleton_, *at);
  }
  if (before.empty() || length < finding.amount) return false;
  return std::ranges::any_of(before, [&](NodeId id) {
    const Node& node = skeleton_[id];
    return !own_.isBeside(before.back(), node.position) &&
           own_.isSeen(before.back(), node.position, node.radius);
  });
}

} // namespace espalier
