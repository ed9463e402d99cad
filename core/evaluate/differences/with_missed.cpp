#include "core/evaluate/differences/with_missed.h"

#include <map>

namespace espalier {

WithMissed withMissed(const Skeleton& result, const Skeleton& reference, const Differences& found) {
  WithMissed both{.skeleton = result, .kinds = found.ofResult};
  std::map<NodeId, NodeId> hosts; // of the result, by the first node of what is missed there
  for (const DifferingPart& part : found.parts)
    if (part.kind == Difference::missed && part.host) hosts[part.nodes.front()] = *part.host;
  std::map<NodeId, NodeId> added; // of the reference, as it is called here
  const auto add = [&](NodeId of, std::optional<NodeId> parent) {
    const Node& node = reference[of];
    added[of] = both.skeleton.add(
        {.position = node.position, .radius = node.radius, .parent = parent, .edge = node.edge});
    both.kinds.push_back(Difference::missed);
  };
  for (const NodeId id : reference.ids()) { // parents first
    const std::optional<NodeId>& parent = reference[id].parent;
    if (!parent || found.ofReference[indexOf(id)] != Difference::missed) continue;
    if (!added.contains(*parent)) {
      const auto host = hosts.find(id);
      add(*parent, host == hosts.end() ? std::nullopt : std::optional(host->second));
    }
    add(id, added.at(*parent));
  }
  return both;
}

} // namespace espalier
