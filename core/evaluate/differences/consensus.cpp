#include "core/evaluate/differences/consensus.h"

#include "core/evaluate/differences/near_edges.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/skeleton/bounds.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/tree_edits.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// By id of the first skeleton: which edges all others have, and where these attach what is there
/// as the first does. An edge goes by the node at its upper end.
struct Agreement {
  std::vector<bool> isThere;
  std::vector<bool> isAttached;
};

bool isOn(const Eigen::Vector3d& place, const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  return (place - start).norm() + (place - end).norm() <= (end - start).norm() * (1 + 1e-9);
}

/// Edges from one down to the one whose lower end, or middle, is at `place`, and on as long as they
/// are not near the other skeleton; none if that place is not below.
/// @param kinds of the edges of the plant, by id
std::vector<NodeId> edgesDownTo(const Eigen::Vector3d& place, const Skeleton& plant, NodeId edge,
                                const std::vector<Difference>& kinds) {
  std::vector<NodeId> edges;
  bool isMet = false;
  for (NodeId next = edge; plant[next].parent; next = *plant[next].parent) {
    if (isMet && kinds[indexOf(next)] == Difference::matched) break;
    edges.push_back(next);
    isMet = isMet || isOn(place, plant[*plant[next].parent].position, plant[next].position);
  }
  return isMet ? edges : std::vector<NodeId>{};
}

/// Wood that two skeletons attach to something else, as one of them sees it.
struct Dispute {
  const DifferingPart* part;      // of that one
  std::vector<NodeId> otherEdges; // by which the other attaches it, from there down
};

std::vector<Dispute> disputesIn(const Differences& found, const Skeleton& other) {
  std::vector<Dispute> disputes;
  for (const DifferingPart& part : found.parts) {
    if (part.kind != Difference::wronglyAttached) continue;
    const std::vector<NodeId>& edges = found.standsOn[indexOf(part.attached)];
    disputes.push_back(
        {&part,
         edges.empty() ? edges : edgesDownTo(part.place, other, edges.front(), found.ofReference)});
  }
  return disputes;
}

bool areSame(const Dispute& one, const Dispute& ofOther) {
  return std::ranges::count(one.otherEdges, ofOther.part->attached) > 0 ||
         std::ranges::count(ofOther.otherEdges, one.part->attached) > 0;
}

/// Of one of two skeletons, the edges by which it or the other sees wood attached elsewhere.
std::vector<bool> disputedEdges(const Skeleton& plant, const std::vector<Dispute>& own,
                                const std::vector<Dispute>& ofOther) {
  std::vector<bool> isDisputed(plant.idEnd(), false);
  for (const Dispute& each : own)
    for (const NodeId id : each.part->nodes)
      isDisputed[indexOf(id)] = true;
  for (const Dispute& each : ofOther)
    for (const NodeId id : each.otherEdges)
      isDisputed[indexOf(id)] = true;
  return isDisputed;
}

void restrictTo(Agreement& agreement, const Differences& found) {
  for (std::size_t id = 0; id < found.ofResult.size(); ++id)
    if (found.ofResult[id] == Difference::invented) agreement.isThere[id] = false;
  for (const DifferingPart& part : found.parts) {
    if (part.kind != Difference::wronglyAttached) continue;
    agreement.isAttached[indexOf(part.attached)] = false;
    for (const NodeId id : part.nodes) // what leads there may be of none of the others
      if (found.standsOn[indexOf(id)].empty()) agreement.isThere[indexOf(id)] = false;
  }
}

/// What is borne along edges that are not all there is a tree of its own already.
void restrictTo(Agreement& agreement, const Dispute& ofOther) {
  if (std::ranges::all_of(ofOther.otherEdges,
                          [&](NodeId id) { return agreement.isThere[indexOf(id)]; }))
    agreement.isAttached[indexOf(ofOther.otherEdges.back())] = false;
}

/// Wood that both have, each from its other end up: their roots are elsewhere, or a branch is
/// attached by its apex. Turns that are shorter than three tolerances do not count: whose wood runs
/// there is not known better.
std::vector<DifferingPart> turnedParts(const Skeleton& first, const Skeleton& other,
                                       const Differences& found) {
  const EdgeIndex edges(other);
  std::vector<bool> isTurned(first.idEnd(), false);
  for (const NodeId id : first.ids()) {
    const auto parent = first[id].parent;
    if (!parent || found.ofResult[indexOf(id)] == Difference::invented) continue;
    const Eigen::Vector3d& start = first[*parent].position;
    const Eigen::Vector3d& end = first[id].position;
    const std::optional<NearestPlace> near = edges.nearest((start + end) / 2);
    const auto below = near ? other[near->node].parent : std::nullopt;
    if (below)
      isTurned[indexOf(id)] =
          (end - start).dot(other[near->node].position - other[*below].position) < 0;
  }
  std::vector<DifferingPart> parts;
  for (std::vector<NodeId>& nodes : stretches(first, isTurned, true)) {
    DifferingPart part{
        .kind = Difference::wronglyAttached, .nodes = std::move(nodes), .at = {}, .attached = {}};
    part.attached = part.nodes.front();
    part.at = first[part.attached].position;
    for (const NodeId id : part.nodes)
      part.length += edgeLength(first, id);
    if (part.length > 3 * found.tolerance) parts.push_back(std::move(part));
  }
  return parts;
}

/// Where two skeletons differ, the longest first; restricts what is agreed on.
std::vector<Disagreement> compared(const Skeleton& first, const Skeleton& other,
                                   const Differences& found, const Differences& back,
                                   Agreement& agreement) {
  const std::vector<Dispute> own = disputesIn(found, other);
  std::vector<Dispute> ofOther = disputesIn(back, first);
  const std::vector<bool> isDisputed = disputedEdges(first, own, ofOther);
  const std::vector<bool> isDisputedInOther = disputedEdges(other, ofOther, own);
  std::erase_if(ofOther, [&](const Dispute& each) {
    return each.otherEdges.empty() ||
           std::ranges::any_of(own, [&](const Dispute& mine) { return areSame(mine, each); });
  });
  restrictTo(agreement, found);
  std::vector<Disagreement> places;
  const auto add = [&](const DifferingPart& part) {
    places.push_back({.kind = part.kind, .length = part.length, .at = part.at});
  };
  for (const DifferingPart& part : found.parts) {
    const std::vector<bool>& disputed =
        part.kind == Difference::missed ? isDisputedInOther : isDisputed;
    const bool leadsToADispute =
        part.kind != Difference::wronglyAttached &&
        std::ranges::all_of(part.nodes, [&](NodeId id) { return disputed[indexOf(id)]; });
    if (!leadsToADispute) add(part);
  }
  for (const Dispute& each : ofOther) {
    restrictTo(agreement, each);
    add(*each.part);
  }
  for (const DifferingPart& part : turnedParts(first, other, found)) {
    for (const NodeId id : part.nodes)
      agreement.isThere[indexOf(id)] = false;
    add(part);
  }
  std::ranges::stable_sort(places, std::greater(), &Disagreement::length);
  return places;
}

/// Fills in `agreed` and `nodes`.
void keepWood(Consensus& consensus, const Skeleton& first, const Agreement& agreement) {
  const std::vector<NodeId> ids = first.ids();
  std::vector<bool> isNeeded(first.idEnd(), false); // a node at an end of an edge that is there
  for (const NodeId id : ids) {
    if (!first[id].parent || !agreement.isThere[indexOf(id)]) continue;
    isNeeded[indexOf(id)] = true;
    if (agreement.isAttached[indexOf(id)]) isNeeded[indexOf(*first[id].parent)] = true;
  }
  std::vector<std::optional<NodeId>> copies(first.idEnd());
  for (const NodeId id : ids) { // parents before their children
    if (!isNeeded[indexOf(id)]) continue;
    const Node& node = first[id];
    Node copy{.position = node.position, .radius = node.radius};
    if (node.parent && agreement.isThere[indexOf(id)] && agreement.isAttached[indexOf(id)]) {
      copy.parent = copies[indexOf(*node.parent)];
      copy.edge = node.edge;
    }
    copies[indexOf(id)] = consensus.agreed.add(copy);
    consensus.nodes.push_back(id);
  }
}

/// Of the length of a skeleton, that which is near another; 0 where that has no length.
double shareNear(const Skeleton& skeleton, const Skeleton& other, double tolerance,
                 const Progress& progress) {
  if (!(totalLength(other) > 0)) return 0;
  const Differences found = differences(skeleton, other, tolerance, progress);
  const double length = totalLength(skeleton);
  return length > 0 ? 1 - found.invented / length : 0;
}

} // namespace

Consensus consensusOf(std::span<const Skeleton> plants, double tolerance,
                      const Progress& progress) {
  assert(plants.size() >= 2);
  const Skeleton& first = plants.front();
  const double steps = 2 * static_cast<double>(plants.size()) - 1;
  double step = 0;
  const auto next = [&] {
    const double begun = step++;
    return progress.part(begun / steps, step / steps);
  };
  Agreement agreement{std::vector<bool>(first.idEnd(), true),
                      std::vector<bool>(first.idEnd(), true)};
  Consensus consensus;
  for (std::size_t i = 1; i < plants.size(); ++i) {
    const Progress both = next();
    const Differences found = differences(first, plants[i], tolerance, both.part(0, 0.5));
    const Differences back = differences(plants[i], first, tolerance, both.part(0.5, 1));
    for (Disagreement& place : compared(first, plants[i], found, back, agreement)) {
      place.with = i;
      consensus.places.push_back(place);
    }
  }
  keepWood(consensus, first, agreement);
  for (const Skeleton& plant : plants)
    consensus.shares.push_back(shareNear(plant, consensus.agreed, tolerance, next()));
  return consensus;
}

double usualDistance(std::span<const Skeleton> plants) {
  double distance = 0;
  for (const Skeleton& plant : plants)
    distance = std::max(distance, usualTolerance(plant));
  return distance;
}

std::optional<std::size_t> inOtherUnit(std::span<const Skeleton> plants) {
  constexpr double most = 9; // times as large
  const auto extent = [&](std::size_t i) { return bounds(plants[i]).diagonal().norm(); };
  for (std::size_t i = 1; i < plants.size(); ++i)
    if (extent(i) > most * extent(0) || extent(0) > most * extent(i)) return i;
  return std::nullopt;
}

std::optional<std::size_t> withoutAgreement(const Consensus& consensus) {
  constexpr double least = 0.01; // of the length
  const auto found = std::ranges::find_if(consensus.shares, [](double s) { return s < least; });
  if (found == consensus.shares.end()) return std::nullopt;
  return static_cast<std::size_t>(found - consensus.shares.begin());
}

void keepAgreed(SkeletonEditor& editor, const Consensus& consensus) {
  std::vector<bool> isKept(editor.skeleton().idEnd(), false);
  for (const NodeId id : consensus.agreed.ids()) {
    const NodeId node = consensus.nodes[indexOf(id)];
    isKept[indexOf(node)] = true;
    if (!consensus.agreed[id].parent && editor.skeleton()[node].parent) cutOff(editor, node);
  }
  for (const NodeId id : editor.skeleton().ids())
    if (!isKept[indexOf(id)] && editor.skeleton().contains(id)) removeSubtree(editor, id);
}

} // namespace espalier
