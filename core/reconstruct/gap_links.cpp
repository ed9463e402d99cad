#include "core/reconstruct/gap_links.h"

#include "core/base/spatial_index.h"
#include "core/graph/arborescence.h"
#include "core/reconstruct/backward_branches.h"

#include <algorithm>
#include <array>
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

  bool operator==(const Bridge&) const = default;
};

/// What speaks for links between fragments.
class BridgeEvidence {
public:
  BridgeEvidence(const Skeleton& skeleton, const Fragments& fragments, const GapOptions& options)
      : skeleton_(skeleton), options_(options), outwards_(skeleton.idEnd()),
        backward_(backwardBranches(skeleton, fragments.isEntry)) {
    for (const NodeId id : skeleton.ids())
      if (neighbors(fragments, id).size() <= 1)
        outwards_[indexOf(id)] = outwardsFrom(fragments, id);
    growth_.resize(skeleton.idEnd(), Vector3d::Zero());
    for (const NodeId id : skeleton.ids())
      growth_[indexOf(id)] = growthAt(fragments, id);
  }

  [[nodiscard]] bool isEnd(NodeId id) const { return outwards_[indexOf(id)].has_value(); }

  [[nodiscard]] GapEvidence of(const Bridge& bridge) const {
    const Vector3d link = skeleton_[bridge.to].position - skeleton_[bridge.from].position;
    GapEvidence evidence{.length = link.norm(), .backward = backward_[indexOf(bridge.to)]};
    evidence.cost = options_.backCost * evidence.backward;
    const std::optional<Vector3d>& below = outwards_[indexOf(bridge.from)];
    evidence.miss = evidence.length;
    evidence.isFromTip = below.has_value();
    if (evidence.length == 0) return evidence;
    evidence.direction = link / evidence.length;
    evidence.goesOn =
        outwards_[indexOf(bridge.to)].value_or(Vector3d::Zero()).dot(-evidence.direction);
    evidence.miss =
        evidence.goesOn > 0
            ? evidence.length * std::sqrt(std::max(0.0, 1 - evidence.goesOn * evidence.goesOn))
            : evidence.length;
    evidence.turn = growth_[indexOf(bridge.from)].dot(evidence.direction);
    const double bearing = skeleton_[bridge.from].radius;
    const double borne = skeleton_[bridge.to].radius;
    if (bearing > 0 && borne > 0)
      evidence.thicker = std::clamp(std::log(borne / bearing), -2.0, 2.0);
    double factor = 1 + turn(evidence.goesOn);
    if (below) {
      evidence.goesOnBelow = below->dot(evidence.direction);
      factor += turn(evidence.goesOnBelow);
      if (bearing > 0 && borne > 0) evidence.radii = std::abs(std::log(borne / bearing));
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

  /// The direction in which the wood grows up to a node, as it is entered now; of the lowest of a
  /// fragment, from it; 0 where that is a single node.
  [[nodiscard]] Vector3d growthAt(const Fragments& fragments, NodeId id) const {
    constexpr int edges = 3;
    NodeId below = id;
    for (int i = 0; i < edges && !fragments.isEntry[indexOf(below)]; ++i)
      below = *skeleton_[below].parent;
    NodeId above = id;
    if (below == id)
      for (const NodeId child : skeleton_.children(id))
        if (!fragments.isEntry[indexOf(child)]) above = child;
    const Vector3d span = skeleton_[above].position - skeleton_[below].position;
    const double length = span.norm();
    return length > 0 ? Vector3d(span / length) : Vector3d::Zero();
  }

  /// 0 for straight on, more the more it turns; between the two where there is no direction.
  [[nodiscard]] double turn(double goesOn) const { return options_.turnCost * (1 - goesOn) / 2; }

  const Skeleton& skeleton_;
  GapOptions options_;
  std::vector<std::optional<Vector3d>> outwards_; // by id, of ends
  std::vector<Vector3d> growth_;                  // by id
  std::vector<double> backward_;                  // by id
};

/// Which of the links between two fragments is the best, by several measures.
struct BestBridges {
  static constexpr std::size_t measures = 3;
  std::array<double, measures> costs;
  std::array<Bridge, measures> bridges;
  std::optional<Bridge> there; // the long edge itself

  /// Each once, the cheapest first.
  [[nodiscard]] std::vector<Bridge> distinct() const {
    std::vector<Bridge> all(bridges.begin(), bridges.end());
    if (there) all.push_back(*there);
    std::vector<Bridge> kept;
    for (const Bridge& bridge : all)
      if (std::ranges::find(kept, bridge) == kept.end()) kept.push_back(bridge);
    return kept;
  }
};

std::array<double, BestBridges::measures> measuresOf(const GapEvidence& evidence) {
  return {evidence.cost, evidence.length, evidence.length + 4 * evidence.miss};
}

/// Nodes of a skeleton by where they are.
class NodePlaces {
public:
  explicit NodePlaces(const Skeleton& skeleton)
      : ids_(skeleton.ids()), origin_(skeleton[ids_.front()].position) {
    places_.resize(3, static_cast<Eigen::Index>(ids_.size()));
    for (std::size_t i = 0; i < ids_.size(); ++i)
      places_.col(static_cast<Eigen::Index>(i)) =
          (skeleton[ids_[i]].position - origin_).cast<float>();
    index_.emplace(places_);
  }

  [[nodiscard]] const std::vector<NodeId>& ids() const { return ids_; }

  template <class Note>
  void within(const Vector3d& place, double distance, const Note& note) const {
    for (const Neighbor& near :
         index_->within((place - origin_).cast<float>(), static_cast<float>(distance)))
      note(ids_[static_cast<std::size_t>(near.index)]);
  }

private:
  std::vector<NodeId> ids_;
  Vector3d origin_;
  Eigen::Matrix3Xf places_;
  std::optional<SpatialIndex> index_;
};

/// The links between each two fragments that are in reach.
std::map<std::pair<std::uint32_t, std::uint32_t>, BestBridges>
bridgesOf(const Skeleton& skeleton, const Fragments& fragments, const GapOptions& options,
          const BridgeEvidence& evidence, const NodePlaces& places, const Progress& progress) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, BestBridges> bridges;
  const auto note = [&](const Bridge& bridge) {
    const std::uint32_t from = fragments.ofNode[indexOf(bridge.from)];
    const std::uint32_t to = fragments.ofNode[indexOf(bridge.to)];
    if (from == to) return;
    const auto measures = measuresOf(evidence.of(bridge));
    const auto [place, isNew] = bridges.try_emplace({from, to});
    BestBridges& best = place->second;
    for (std::size_t i = 0; i < BestBridges::measures; ++i)
      if (isNew || measures[i] < best.costs[i]) {
        best.costs[i] = measures[i];
        best.bridges[i] = bridge;
      }
    if (skeleton[bridge.to].parent == bridge.from) best.there = bridge;
  };
  const std::vector<NodeId>& ids = places.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i % 64 == 0) progress.update(static_cast<double>(i) / static_cast<double>(ids.size()));
    const NodeId to = ids[i];
    const std::uint32_t fragment = fragments.ofNode[indexOf(to)];
    const NodeId entry = fragments.entries[fragment];
    if (!skeleton[entry].parent) continue; // that of a root stays as it is
    if (to != entry && !evidence.isEnd(to)) continue;
    if (to == entry) note({*skeleton[to].parent, to});
    places.within(skeleton[to].position, options.reach, [&](NodeId from) { note({from, to}); });
  }
  return bridges;
}

/// The share of the middle of a link that nodes are near of wood that it does not join.
/// @param farthest  [L] that any link reaches
double passesOf(const Skeleton& skeleton, const Fragments& fragments, const NodePlaces& places,
                const Bridge& bridge, double farthest) {
  const Vector3d& from = skeleton[bridge.from].position;
  const Vector3d span = skeleton[bridge.to].position - from;
  const double near = std::min(span.norm() / 4, farthest / 20);
  const std::uint32_t bearer = fragments.ofNode[indexOf(bridge.from)];
  const std::uint32_t borne = fragments.ofNode[indexOf(bridge.to)];
  constexpr std::array<double, 4> shares = {0.3, 0.45, 0.6, 0.75};
  double passed = 0;
  for (const double share : shares) {
    bool isNear = false;
    places.within(from + share * span, near, [&](NodeId id) {
      const std::uint32_t fragment = fragments.ofNode[indexOf(id)];
      isNear = isNear || (fragment != bearer && fragment != borne);
    });
    passed += isNear ? 1.0 / shares.size() : 0;
  }
  return passed;
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
    const BridgeEvidence evidence(skeleton, fragments, options);
    const NodePlaces places(skeleton);
    for (const auto& [pair, best] :
         bridgesOf(skeleton, fragments, options, evidence, places, progress)) {
      for (const Bridge& bridge : best.distinct()) {
        GapLink link{bridge.from, bridge.to, pair.first, pair.second, evidence.of(bridge)};
        link.evidence.isThere = best.there == bridge;
        link.evidence.nodes = fragments.nodes[pair.first];
        link.evidence.passes = passesOf(skeleton, fragments, places, bridge, options.reach);
        gaps.links.push_back(link);
      }
    }
  }
  gaps.entries = std::move(fragments.entries);
  gaps.nodes = std::move(fragments.nodes);
  return gaps;
}

bool isAlike(const Skeleton& skeleton, const GapLink& a, const GapLink& b, double near) {
  const double apart = (skeleton[a.from].position - skeleton[b.from].position).norm();
  return a.to == b.to && apart <= near + 0.2 * std::min(a.evidence.length, b.evidence.length);
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
