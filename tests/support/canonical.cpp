#include "tests/support/canonical.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

namespace espalier::test {

Skeleton canonical(const Skeleton& skeleton) {
  const auto comesLast = [&](NodeId a, NodeId b) {
    const auto key = [&](const Node& node) {
      return std::tuple(node.edge, node.position.x(), node.position.y(), node.position.z(),
                        node.radius);
    };
    return key(skeleton[b]) < key(skeleton[a]);
  };
  struct Step {
    NodeId from;
    std::optional<NodeId> parent;
  };
  std::vector<Step> stack;
  const auto push = [&](std::vector<NodeId> nodes, std::optional<NodeId> parent) {
    std::ranges::sort(nodes, comesLast); // the last one on the stack is taken first
    for (const NodeId node : nodes)
      stack.push_back({node, parent});
  };
  Skeleton result;
  push(skeleton.roots(), std::nullopt);
  while (!stack.empty()) {
    const Step step = stack.back();
    stack.pop_back();
    Node node = skeleton[step.from];
    node.parent = step.parent;
    if (!node.parent) node.edge = EdgeType::successor; // without meaning for a root
    const NodeId id = result.add(node);
    push(skeleton.children(step.from), id);
  }
  return result;
}

Skeleton withoutEntities(Skeleton skeleton) {
  for (const NodeId id : skeleton.ids())
    skeleton.setEntities(id, {});
  return skeleton;
}

Skeleton withoutOrigins(Skeleton skeleton) {
  for (const NodeId id : skeleton.ids())
    skeleton.setRadius(id, skeleton[id].radius);
  return skeleton;
}

} // namespace espalier::test
