#include "core/evaluate/differences/differences.h"

#include "core/evaluate/differences/attachment.h"
#include "core/evaluate/differences/near_edges.h"
#include "core/evaluate/match/comparable.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

std::vector<Difference> kindsOf(const std::vector<bool>& near, Difference otherwise) {
  std::vector<Difference> kinds;
  kinds.reserve(near.size());
  for (const bool isNear : near)
    kinds.push_back(isNear ? Difference::matched : otherwise);
  return kinds;
}

/// What is attached from a node on, up to its first branching or to what is not near.
std::vector<NodeId> axisFrom(const Skeleton& result, const std::vector<Difference>& kinds,
                             NodeId id) {
  std::vector<NodeId> nodes = {id};
  for (;;) {
    const std::vector<NodeId>& children = result.children(nodes.back());
    if (children.size() != 1 || kinds[indexOf(children[0])] != Difference::matched) return nodes;
    nodes.push_back(children[0]);
  }
}

/// What is not near and leads to nothing but this node, parents before their children.
std::vector<NodeId> bridgeTo(const Skeleton& result, const std::vector<Difference>& kinds,
                             NodeId id) {
  std::vector<NodeId> nodes;
  for (auto below = result[id].parent; below && kinds[indexOf(*below)] == Difference::invented &&
                                       result.children(*below).size() == 1;
       below = result[*below].parent)
    nodes.push_back(*below);
  std::ranges::reverse(nodes);
  return nodes;
}

/// Length of all that a node carries, and of the edge to it [L].
double carriedLength(const Skeleton& result, NodeId id) {
  double sum = edgeLength(result, id);
  std::vector<NodeId> open = {id};
  while (!open.empty()) {
    const NodeId next = open.back();
    open.pop_back();
    for (const NodeId child : result.children(next)) {
      sum += edgeLength(result, child);
      open.push_back(child);
    }
  }
  return sum;
}

void addWronglyAttached(Differences& found, const Skeleton& result,
                        const std::vector<WrongAttachment>& wrong) {
  for (const WrongAttachment& each : wrong) {
    DifferingPart part{.kind = Difference::wronglyAttached,
                       .nodes = bridgeTo(result, found.ofResult, each.node),
                       .length = carriedLength(result, each.node),
                       .at = result[each.node].position,
                       .attached = each.node,
                       .host = each.right.host,
                       .place = each.right.place,
                       .edge = each.right.edge};
    for (const NodeId id : axisFrom(result, found.ofResult, each.node))
      part.nodes.push_back(id);
    for (const NodeId id : part.nodes)
      found.ofResult[indexOf(id)] = Difference::wronglyAttached;
    found.parts.push_back(std::move(part));
  }
}

void addStretches(Differences& found, const Skeleton& skeleton,
                  const std::vector<Difference>& kinds, Difference kind) {
  std::vector<bool> isOfKind;
  isOfKind.reserve(kinds.size());
  for (const Difference each : kinds)
    isOfKind.push_back(each == kind);
  for (std::vector<NodeId>& nodes : stretches(skeleton, isOfKind, true)) {
    DifferingPart part{.kind = kind, .nodes = std::move(nodes)};
    for (const NodeId id : part.nodes)
      part.length += edgeLength(skeleton, id);
    part.at = skeleton[part.nodes.front()].position;
    if (part.length > 0) found.parts.push_back(std::move(part));
  }
}

} // namespace

Differences differences(const Skeleton& result, const Skeleton& reference, double tolerance,
                        const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  Differences found{.tolerance = tolerance};
  found.ofResult =
      kindsOf(nearEdges(result, reference, tolerance, progress.part(0, 0.4)), Difference::invented);
  found.ofReference =
      kindsOf(nearEdges(reference, result, tolerance, progress.part(0.4, 0.8)), Difference::missed);
  const Attachments attachments(result, reference, found.ofResult, tolerance);
  progress.update(0.9);
  found.standsOn = attachments.standsOn();
  addWronglyAttached(found, result, attachments.wrong());
  addStretches(found, result, found.ofResult, Difference::invented);
  addStretches(found, reference, found.ofReference, Difference::missed);
  for (DifferingPart& part : found.parts) {
    if (part.kind != Difference::missed) continue;
    const auto below = reference[part.nodes.front()].parent;
    if (!below) continue; // a root is attached to nothing
    const Attachment right = attachments.on(*below);
    part.host = right.host;
    part.place = reference[*below].position;
    part.edge = reference[part.nodes.front()].edge;
  }
  std::ranges::stable_sort(found.parts, std::greater(), &DifferingPart::length);
  for (const NodeId id : result.ids())
    (found.ofResult[indexOf(id)] == Difference::invented ? found.invented
                                                         : found.matchedInResult) +=
        edgeLength(result, id);
  for (const NodeId id : reference.ids())
    (found.ofReference[indexOf(id)] == Difference::missed ? found.missed
                                                          : found.matchedInReference) +=
        edgeLength(reference, id);
  progress.update(1);
  return found;
}

bool isSame(const DifferingPart& a, const DifferingPart& b, double tolerance) {
  return a.kind == b.kind && (a.at - b.at).norm() <= tolerance;
}

std::string nameOf(Difference difference) {
  switch (difference) {
  case Difference::matched:
    return "matched";
  case Difference::missed:
    return "missed";
  case Difference::invented:
    return "invented";
  case Difference::wronglyAttached:
    return "wrongly_attached";
  }
  return {};
}

} // namespace espalier
