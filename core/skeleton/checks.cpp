#include "core/skeleton/checks.h"

#include <algorithm>

namespace espalier {
namespace {

std::ptrdiff_t successorCount(const Skeleton& skeleton, NodeId id) {
  const std::vector<NodeId>& children = skeleton.children(id);
  return std::count_if(children.begin(), children.end(),
                       [&](NodeId child) { return skeleton[child].edge == EdgeType::successor; });
}

} // namespace

std::vector<Finding> check(const Skeleton& skeleton) {
  std::vector<Finding> findings;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (successorCount(skeleton, id) > 1) findings.push_back({Finding::Kind::twoSuccessors, id});
    if (!node.parent) continue;
    const Node& parent = skeleton[*node.parent];
    if (node.position == parent.position) findings.push_back({Finding::Kind::noLength, id});
    constexpr double rounding = 1 + 1e-9;
    if (node.radius > parent.radius * rounding)
      findings.push_back({Finding::Kind::radiusAboveParent, id});
  }
  return findings;
}

std::string describe(const Finding& finding, const Skeleton& skeleton) {
  const std::string node = "node " + std::to_string(indexOf(finding.node));
  switch (finding.kind) {
  case Finding::Kind::twoSuccessors:
    return node + " has " + std::to_string(successorCount(skeleton, finding.node)) +
           " successors: an axis continues once";
  case Finding::Kind::noLength:
    return node + " lies on its parent: the edge has no length";
  case Finding::Kind::radiusAboveParent:
    return node + " is thicker than its parent";
  }
  return {};
}

std::string nameOf(Finding::Kind kind) {
  switch (kind) {
  case Finding::Kind::twoSuccessors:
    return "two_successors";
  case Finding::Kind::noLength:
    return "no_length";
  case Finding::Kind::radiusAboveParent:
    return "radius_above_parent";
  }
  return {};
}

} // namespace espalier
