#include "core/reconstruct/gap_links.h"

#include "core/base/spatial_index.h"
#include "core/graph/arborescence.h"
#include "core/reconstruct/backward_branches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// The pieces of a skeleton between its long edges.
struct Fragments {
  std::vector<std::uint32_t> ofNode; // by id
  std::vector<bool> isEntry;         // by id
  std::vector<NodeId> entries;       // where each is entered now: its lowest node
  std::vector<std::size_t> nodes;    // in each
};

/// How much longer the edge to a node is than the wood at its ends is thick [L].
double gapBelow(const Skeleton& skeleton, NodeId id) {
  const Node& upper = skeleton[id];
  const Node& lower = skeleton[*upper.parent];
  return (upper.position - lower.position).norm() - 2 * (lower.radius + upper.radius);
}

Fragments fragmentsOf(const Skeleton& skeleton, double widest) {
  Fragments fragments;
  fragments.ofNode.resize(skeleton.idEnd());
  fragments.isEntry.resize(skeleton.idEnd(), false);
  for (const NodeId id : skeleton.ids()) {
    const auto parent = skeleton[id].parent;
    const bool isEntry = !parent || gapBelow(skeleton, id) > widest;
    fragments.isEntry[indexOf(id)] = isEntry;
    fragments.ofNode[indexOf(id)] = isEntry ? static_cast<std::uint32_t>(fragments.entries.size())
                                            : fragments.ofNode[indexOf(*parent)];
    if (isEntry) {
      fragments.entries.push_back(id);
      fragments.nodes.push_back(0);
    }
    ++fragments.nodes[fragments.ofNode[indexOf(id)]];
  }
  return fragments;
}

struct Bridge {
  NodeId from;
  NodeId to;
};

/// What links between fragments cost.
class BridgeCosts {
public:
  BridgeCosts(const Skeleton& skeleton, const Fragments& fragments, const GapOptions& options)
      : skeleton_(skeleton), options_(options), outwards_(skeleton.idEnd()),
        backward_(backwardBranches(skeleton, fragments.isEntry)) {
    for (const NodeId id : skeleton.ids())
      if (neighbors(fragments, id).size() <= 1)
        outwards_[indexOf(id)] = outwardsFrom(fragments, id);
  }

  [[nodiscard]] bool isEnd(NodeId id) const { return outwards_[indexOf(id)].has_value(); }

  /// What a link costs [L]; never under its length.
  [[nodiscard]] double of(const Bridge& bridge) const { return evidenceOf(bridge).cost; }

  [[nodiscard]] GapEvidence evidenceOf(const Bridge& bridge) const {
    const Vector3d link = skeleton_[bridge.to].position - skeleton_[bridge.from].position;
    GapEvidence evidence{.length = link.norm(), .backward = backward_[indexOf(bridge.to)]};
    evidence.cost = options_.backCost * evidence.backward;
    const std::optional<Vector3d>& below = outwards_[indexOf(bridge.from)];
    evidence.isFromTip = below.has_value();
    if (evidence.length == 0) return evidence;
    evidence.direction = link / evidence.length;
    evidence.goesOn =
        outwards_[indexOf(bridge.to)].value_or(Vector3d::Zero()).dot(-evidence.direction);
    double factor = 1 + turn(evidence.goesOn);
    if (below) {
      evidence.goesOnBelow = below->dot(evidence.direction);
      factor += turn(evidence.goesOnBelow);
      const double lower = skeleton_[bridge.from].radius;
      const double upper = skeleton_[bridge.to].radius;
      if (lower > 0 && upper > 0) evidence.radii = std::abs(std::log(upper / lower));
      factor *= 1 + evidence.radii / 2;
    }
    evidence.cost += evidence.length * factor;
    return evidence;
  }

private:
  /// The nodes of the same fragment that an edge joins to one.
  [[nodiscard]] std::vector<NodeId> neighbors(const Fragments& fragments, NodeId id) const {
    std::vector<NodeId> result;
    if (!fragments.isEntry[indexOf(id)]) result.push_back(*skeleton_[id].parent);
    for (const NodeId child : skeleton_.children(id))
      if (!fragments.isEntry[indexOf(child)]) result.push_back(child);
    return result;
  }

  /// The direction outwards from an end of a fragment; 0 where that is a single node.
  [[nodiscard]] Vector3d outwardsFrom(const Fragments& fragments, NodeId end) const {
    constexpr int edges = 4; // single ones stray
    NodeId before = end;
    NodeId at = end;
    for (int i = 0; i < edges; ++i) {
      const std::vector<NodeId> next = neighbors(fragments, at);
      const auto on = std::ranges::find_if(next, [&](NodeId id) { return id != before; });
      if (next.size() > 2 || on == next.end()) break;
      before = at;
      at = *on;
    }
    const Vector3d span = skeleton_[end].position - skeleton_[at].position;
    const double length = span.norm();
    return length > 0 ? Vector3d(span / length) : Vector3d::Zero();
  }

  /// 0 for straight on, more the more it turns; between the two where there is no direction.
  [[nodiscard]] double turn(double goesOn) const { return options_.turnCost * (1 - goesOn) / 2; }

  const Skeleton& skeleton_;
  GapOptions options_;
  std::vector<std::optional<Vector3d>> outwards_; // by id, of ends
  std::vector<double> backward_;                  // by id
};

/// The cheapest link between each two fragments that are in reach.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<double, Bridge>>
bridgesOf(const Skeleton& skeleton, const Fragments& fragments, const GapOptions& options,
          const BridgeCosts& costs, const Progress& progress) {
  const std::vector<NodeId> ids = skeleton.ids();
  const Vector3d origin = skeleton[ids.front()].position;
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = (skeleton[ids[i]].position - origin).cast<float>();
  const SpatialIndex index(places);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<double, Bridge>> bridges;
  const auto note = [&](const Bridge& bridge) {
    const std::uint32_t from = fragments.ofNode[indexOf(bridge.from)];
    const std::uint32_t to = fragments.ofNode[indexOf(bridge.to)];
    if (from == to) return;
    const double cost = costs.of(bridge);
    const auto [place, isNew] = bridges.try_emplace({from, to}, cost, bridge);
    if (!isNew && cost < place->second.first) place->second = {cost, bridge};
  };
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i % 64 == 0) progress.update(static_cast<double>(i) / static_cast<double>(ids.size()));
    const NodeId to = ids[i];
    const std::uint32_t fragment = fragments.ofNode[indexOf(to)];
    const NodeId entry = fragments.entries[fragment];
    if (!skeleton[entry].parent) continue; // that of a root stays as it is
    if (to != entry && !costs.isEnd(to)) continue;
    if (to == entry) note({*skeleton[to].parent, to});
    for (const Neighbor& near :
         index.within(places.col(static_cast<Eigen::Index>(i)), static_cast<float>(options.reach)))
      note({ids[static_cast<std::size_t>(near.index)], to});
  }
  return bridges;
}

/// Attaches a fragment, turned around where need be, to a node of another.
void attach(Skeleton& skeleton, const GapLink& bridge, NodeId entry) {
  std::vector<NodeId> path = {bridge.to}; // down to where it was entered
  while (path.back() != entry)
    path.push_back(*skeleton[path.back()].parent);
  for (const NodeId id : path)
    skeleton.makeRoot(id);
  for (std::size_t i = 1; i < path.size(); ++i)
    skeleton.reparent(path[i], path[i - 1], EdgeType::successor);
  skeleton.reparent(bridge.to, bridge.from, EdgeType::successor);
}

} // namespace

Gaps gapsIn(const Skeleton& skeleton, const GapOptions& options, const Progress& progress) {
  progress.check();
  Gaps gaps;
  if (skeleton.isEmpty()) return gaps;
  Fragments fragments = fragmentsOf(skeleton, options.widest);
  if (fragments.entries.size() > 1) {
    const BridgeCosts costs(skeleton, fragments, options);
    for (const auto& [pair, best] : bridgesOf(skeleton, fragments, options, costs, progress)) {
      const Bridge& bridge = best.second;
      GapLink link{bridge.from, bridge.to, pair.first, pair.second, costs.evidenceOf(bridge)};
      link.evidence.isThere = skeleton[bridge.to].parent == bridge.from;
      link.evidence.nodes = fragments.nodes[pair.first];
      gaps.links.push_back(link);
    }
  }
  gaps.entries = std::move(fragments.entries);
  gaps.nodes = std::move(fragments.nodes);
  return gaps;
}

LinkedFragments linkedBy(const Skeleton& skeleton, const Gaps& gaps,
                         const std::vector<double>& costs) {
  const auto count = static_cast<std::uint32_t>(gaps.entries.size());
  LinkedFragments result{skeleton, std::vector<int>(count, -1)};
  if (count <= 1) return result;
  std::vector<DirectedLink> links;
  for (std::size_t i = 0; i < gaps.links.size(); ++i)
    links.push_back({gaps.links[i].bearer, gaps.links[i].borne, costs[i]});
  result.chosen = minimumArborescence(count, 0, links);
  // From the root's fragment up, so that nothing is attached to what it carries.
  std::vector<std::vector<std::uint32_t>> carried(count);
  for (std::uint32_t fragment = 0; fragment < count; ++fragment) {
    if (result.chosen[fragment] < 0) continue;
    result.skeleton.makeRoot(gaps.entries[fragment]);
    carried[links[static_cast<std::size_t>(result.chosen[fragment])].from].push_back(fragment);
  }
  std::vector<std::uint32_t> open = {0};
  for (std::size_t i = 0; i < open.size(); ++i)
    for (const std::uint32_t fragment : carried[open[i]]) {
      attach(result.skeleton, gaps.links[static_cast<std::size_t>(result.chosen[fragment])],
             gaps.entries[fragment]);
      open.push_back(fragment);
    }
  return result;
}

} // namespace espalier
