#include "core/skeleton/branch_end.h"

#include <algorithm>
#include <utility>

namespace espalier {

std::optional<BranchEnd> branchEndAt(const Skeleton& skeleton, NodeId tip) {
  BranchEnd end;
  NodeId at = tip;
  while (const auto parent = skeleton[at].parent) {
    end.nodes.push_back(at);
    end.length += (skeleton[at].position - skeleton[*parent].position).norm();
    at = *parent;
    if (skeleton.children(at).size() > 1) {
      end.foot = at;
      return end;
    }
  }
  return std::nullopt;
}

std::size_t tipCount(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  return static_cast<std::size_t>(
      std::ranges::count_if(ids, [&](NodeId id) { return skeleton.children(id).empty(); }));
}

std::vector<BranchEnd> branchEnds(const Skeleton& skeleton) {
  std::vector<BranchEnd> ends;
  for (const NodeId id : skeleton.ids())
    if (skeleton.children(id).empty())
      if (auto end = branchEndAt(skeleton, id)) ends.push_back(std::move(*end));
  return ends;
}

} // namespace espalier
