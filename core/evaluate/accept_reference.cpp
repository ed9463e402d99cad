#include "core/evaluate/accept_reference.h"

#include "core/base/error.h"
#include "core/skeleton/edits.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace espalier {
namespace {

void requireThere(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  for (const NodeId id : nodes)
    if (!skeleton.contains(id))
      throw Error("this part has been edited since it was compared: wait until it is compared "
                  "again");
}

/// A place on the edge to a node.
struct Spot {
  NodeId node;
  double share;    // of the way up to it
  double distance; // from the place looked for [L]
};

Spot spotOn(const Skeleton& skeleton, NodeId id, const Eigen::Vector3d& place) {
  const Node& node = skeleton[id];
  if (!node.parent) return {id, 1, (node.position - place).norm()};
  const Eigen::Vector3d start = skeleton[*node.parent].position;
  const Eigen::Vector3d way = node.position - start;
  const double squared = way.squaredNorm();
  const double share = squared > 0 ? std::clamp(way.dot(place - start) / squared, 0.0, 1.0) : 1;
  return {id, share, (start + share * way - place).norm()};
}

/// A node at the place nearest to `place` on the edges that meet at `host`: one that is there
/// within the tolerance, else a new one on its edge. Not on what `hanging` carries.
NodeId nodeAt(SkeletonEditor& editor, NodeId host, const Eigen::Vector3d& place, double tolerance,
              std::optional<NodeId> hanging) {
  const Skeleton& skeleton = editor.skeleton();
  Spot best = spotOn(skeleton, host, place);
  for (const NodeId child : skeleton.children(host)) {
    if (hanging && skeleton.isAncestor(child, *hanging)) continue; // the way that is to be left
    if (const Spot spot = spotOn(skeleton, child, place); spot.distance < best.distance)
      best = spot;
  }
  const auto parent = skeleton[best.node].parent;
  if (!parent) return best.node;
  const double length = (skeleton[best.node].position - skeleton[*parent].position).norm();
  if ((1 - best.share) * length <= tolerance) return best.node;
  if (best.share * length <= tolerance) return *parent;
  return splitEdge(editor, best.node, best.share);
}

/// Gives an edge the type of the reference. What else continued the axis there branches.
void setType(SkeletonEditor& editor, NodeId id, EdgeType wanted) {
  if (editor.skeleton()[id].parent && editor.skeleton()[id].edge != wanted)
    setEdgeType(editor, id, wanted);
}

/// Removes what leads to nothing any more: stretches without a match that carry nothing.
void removeDeadEnd(SkeletonEditor& editor, const Differences& found, std::optional<NodeId> end) {
  while (end && editor.skeleton().children(*end).empty() && indexOf(*end) < found.ofResult.size() &&
         found.ofResult[indexOf(*end)] != Difference::matched &&
         found.standsOn[indexOf(*end)].empty()) {
    const std::optional<NodeId> below = editor.skeleton()[*end].parent;
    removeNode(editor, *end);
    end = below;
  }
}

void hang(SkeletonEditor& editor, const Differences& found, NodeId id, NodeId onto,
          EdgeType wanted) {
  const std::optional<NodeId> before = editor.skeleton()[id].parent;
  if (before == onto) return;
  editor.reparent(id, onto, EdgeType::branching);
  setType(editor, id, wanted);
  removeDeadEnd(editor, found, before);
}

/// The lowest of what stands on the way up from an edge of the reference: by edge.
std::unordered_map<std::uint32_t, NodeId> lowestOn(const Skeleton& skeleton,
                                                   const Differences& found) {
  std::unordered_map<std::uint32_t, NodeId> lowest;
  for (const NodeId id : skeleton.ids()) { // parents before their children
    if (indexOf(id) >= found.standsOn.size()) continue;
    for (const NodeId edge : found.standsOn[indexOf(id)])
      lowest.try_emplace(static_cast<std::uint32_t>(indexOf(edge)), id);
  }
  return lowest;
}

/// Copies what was missed, node by node.
class Copier {
public:
  Copier(SkeletonEditor& editor, const Differences& found, const Skeleton& reference)
      : editor_(editor), found_(found), reference_(reference),
        lowest_(lowestOn(editor.skeleton(), found)), copies_(reference.idEnd()) {}

  /// Copies a node, or takes the one of the result that stands there. Of several from one part, the
  /// first is hung on `host`, the others on the copies of their parents.
  void copy(NodeId id, std::optional<NodeId> host) {
    const Node& node = reference_[id];
    if (!host && node.parent) host = copies_[indexOf(*node.parent)];
    const std::optional<NodeId> there = standing(id, host);
    if (there && (editor_.skeleton()[*there].position - node.position).norm() <= found_.tolerance) {
      if (host) hang(editor_, found_, *there, *host, node.edge);
      copies_[indexOf(id)] = there;
      return;
    }
    added_.push_back(editor_.add({.position = node.position,
                                  .radius = node.radius,
                                  .parent = host,
                                  .edge = EdgeType::branching}));
    setType(editor_, added_.back(), node.edge);
    copies_[indexOf(id)] = added_.back();
  }
  /// Hangs what the reference goes on with above a copied node on its copy.
  void goOnAbove(NodeId id) {
    for (const NodeId above : reference_.children(id)) {
      if (copies_[indexOf(above)]) continue;
      const std::optional<NodeId> next = standing(above, copies_[indexOf(id)]);
      if (next) hang(editor_, found_, *next, *copies_[indexOf(id)], reference_[above].edge);
    }
  }
  [[nodiscard]] const std::vector<NodeId>& added() const { return added_; }

private:
  /// The lowest of the result on an edge of the reference, unless it carries `host`.
  [[nodiscard]] std::optional<NodeId> standing(NodeId edge, std::optional<NodeId> host) const {
    const auto at = lowest_.find(static_cast<std::uint32_t>(indexOf(edge)));
    if (at == lowest_.end() || !editor_.skeleton().contains(at->second)) return std::nullopt;
    if (host && editor_.skeleton().isAncestor(at->second, *host)) return std::nullopt;
    return at->second;
  }

  SkeletonEditor& editor_;
  const Differences& found_;
  const Skeleton& reference_;
  std::unordered_map<std::uint32_t, NodeId> lowest_;
  std::vector<std::optional<NodeId>> copies_; // by id of the reference
  std::vector<NodeId> added_;
};

std::vector<NodeId> copyMissed(SkeletonEditor& editor, const Differences& found,
                               const Skeleton& reference, const DifferingPart& part) {
  std::optional<NodeId> host = part.host;
  if (host) {
    requireThere(editor.skeleton(), {*host});
    host = nodeAt(editor, *host, part.place, found.tolerance, std::nullopt);
  }
  Copier copier(editor, found, reference);
  for (const NodeId id : part.nodes)
    copier.copy(id, id == part.nodes.front() ? host : std::nullopt);
  for (const NodeId id : part.nodes)
    copier.goOnAbove(id);
  return copier.added();
}

/// What of it ends on the reference stays: only the way there is invented.
std::vector<NodeId> removeInvented(SkeletonEditor& editor, const Differences& found,
                                   const DifferingPart& part) {
  requireThere(editor.skeleton(), part.nodes);
  const std::optional<NodeId> below = editor.skeleton()[part.nodes.front()].parent;
  bool isRemoved = false;
  for (std::size_t i = part.nodes.size(); i-- > 0;) { // children first
    const NodeId id = part.nodes[i];
    if (!found.standsOn[indexOf(id)].empty()) continue;
    removeNode(editor, id);
    isRemoved = true;
  }
  if (!isRemoved)
    throw Error("what hangs here is of the reference: accept what was missed beside it, or attach "
                "it elsewhere");
  return below ? std::vector{*below} : std::vector<NodeId>();
}

std::vector<NodeId> hangRight(SkeletonEditor& editor, const Differences& found,
                              const DifferingPart& part) {
  requireThere(editor.skeleton(), {part.hanging, *part.host});
  const Skeleton& skeleton = editor.skeleton();
  if (skeleton.isAncestor(part.hanging, *part.host))
    throw Error("what this should hang on hangs on it now: accept that part first");
  const NodeId onto = nodeAt(editor, *part.host, part.place, found.tolerance, part.hanging);
  hang(editor, found, part.hanging, onto, part.edge);
  return {part.hanging};
}

} // namespace

std::vector<NodeId> acceptReference(SkeletonEditor& editor, const Differences& found,
                                    const Skeleton& reference, const DifferingPart& part) {
  switch (part.kind) {
  case Difference::missed:
    return copyMissed(editor, found, reference, part);
  case Difference::invented:
    return removeInvented(editor, found, part);
  case Difference::wronglyAttached:
    return hangRight(editor, found, part);
  case Difference::matched:
    break;
  }
  return {};
}

} // namespace espalier
