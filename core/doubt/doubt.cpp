#include "core/doubt/doubt.h"

#include "core/skeleton/edits.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// A node that goes on in one child alone goes on with its axis there.
void goOnAt(SkeletonEditor& editor, NodeId id) {
  const std::vector<NodeId>& children = editor.skeleton().children(id);
  if (children.size() == 1 && editor.skeleton()[children.front()].edge == EdgeType::branching)
    setEdgeType(editor, children.front(), EdgeType::successor);
}

/// Whether the place that a branch would be added to is one of the plant still: the node, or the
/// edge below it.
bool hasPlaceOf(const GrownBranch& branch, const Skeleton& before, const Skeleton& now) {
  return branch.fraction == 1 || before[branch.on].parent == now[branch.on].parent;
}

} // namespace

std::string nameOf(Doubt::Kind kind) {
  switch (kind) {
  case Doubt::Kind::end:
    return "end";
  case Doubt::Kind::attachment:
    return "attachment";
  case Doubt::Kind::missing:
    return "missing";
  }
  return {};
}

std::string nameOf(Alternative::Kind kind) {
  switch (kind) {
  case Alternative::Kind::asItIs:
    return "as_it_is";
  case Alternative::Kind::remove:
    return "remove";
  case Alternative::Kind::attach:
    return "attach";
  case Alternative::Kind::add:
    return "add";
  }
  return {};
}

std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> endsOfAdded(const Doubt& doubt) {
  const auto added = std::ranges::find(doubt.alternatives, Alternative::Kind::add,
                                       [](const Alternative& one) { return one.kind; });
  if (added == doubt.alternatives.end()) return std::nullopt;
  const Skeleton& part = added->branch->part;
  const std::vector<NodeId> ids = part.ids();
  return std::pair(part[ids.front()].position, part[ids.back()].position);
}

bool isSame(const Doubt& a, const Doubt& b, double near) {
  const auto endsOfA = endsOfAdded(a);
  const auto endsOfB = endsOfAdded(b);
  if (!endsOfA || !endsOfB) return !endsOfA && !endsOfB && a.node == b.node;
  return (endsOfA->first - endsOfB->first).norm() <= near &&
         (endsOfA->second - endsOfB->second).norm() <= near;
}

bool isThere(const Doubt& doubt, const Skeleton& skeleton) {
  const auto has = [&](NodeId id) { return skeleton.contains(id); };
  const auto carriesOther = [&](NodeId id) {
    return std::ranges::any_of(skeleton.children(id), [&](NodeId child) {
      return std::ranges::find(doubt.nodes, child) == doubt.nodes.end();
    });
  };
  return has(doubt.node) && std::ranges::all_of(doubt.nodes, has) &&
         std::ranges::all_of(doubt.alternatives, [&](const Alternative& one) {
           if (one.kind == Alternative::Kind::remove)
             return std::ranges::none_of(doubt.nodes, carriesOther);
           if (one.onto) return has(*one.onto) && !skeleton.isAncestor(doubt.node, *one.onto);
           return !one.branch || has(one.branch->on);
         });
}

void settle(SkeletonEditor& editor, const Doubt& doubt, const Alternative& alternative,
            const std::optional<std::string>& reviewer) {
  std::vector<NodeId> looked;
  switch (alternative.kind) {
  case Alternative::Kind::asItIs:
    looked = doubt.nodes;
    break;
  case Alternative::Kind::remove: {
    const std::optional<NodeId> foot = editor.skeleton()[doubt.node].parent;
    removeSubtree(editor, doubt.node);
    if (foot) goOnAt(editor, *foot);
    break;
  }
  case Alternative::Kind::attach: {
    const std::optional<NodeId> foot = editor.skeleton()[doubt.node].parent;
    reparentNode(editor, doubt.node, *alternative.onto);
    if (foot) goOnAt(editor, *foot);
    looked = doubt.nodes;
    break;
  }
  case Alternative::Kind::add:
    looked = addGrown(editor, {*alternative.branch}).front();
    for (std::size_t i = 0; i < looked.size(); ++i) // those that they carry, too
      std::ranges::copy(editor.skeleton().children(looked[i]), std::back_inserter(looked));
    break;
  }
  if (!reviewer) return;
  for (const NodeId id : looked)
    editor.setReview(id, {.state = ReviewState::reviewed,
                          .comment = editor.skeleton()[id].review.comment,
                          .reviewer = *reviewer});
}

std::vector<std::size_t> decideByOdds(SkeletonEditor& editor, const std::vector<Doubt>& doubts,
                                      double least) {
  using Kind = Alternative::Kind;
  std::vector<std::size_t> changed;
  const Skeleton before = editor.skeleton();
  std::vector<GrownBranch> added;
  // What goes first, so that nothing is attached to it; what is new last and all at once, as the
  // places on edges are those of now.
  for (const Kind kind : {Kind::remove, Kind::attach, Kind::add})
    for (std::size_t i = 0; i < doubts.size(); ++i) {
      const Doubt& doubt = doubts[i];
      const Alternative& likeliest = doubt.alternatives.front();
      if (likeliest.kind != kind || likeliest.probability < least) continue;
      if (!isThere(doubt, editor.skeleton())) continue;
      if (kind == Kind::add) {
        if (!hasPlaceOf(*likeliest.branch, before, editor.skeleton())) continue;
        added.push_back(*likeliest.branch);
        changed.push_back(i);
        continue;
      }
      const std::optional<NodeId> foot = editor.skeleton()[doubt.node].parent;
      const bool isLast = foot && editor.skeleton().children(*foot).size() == 1;
      if (kind == Kind::remove && isLast) continue; // of the ends at one foot one stays
      settle(editor, doubt, likeliest, std::nullopt);
      changed.push_back(i);
    }
  if (!added.empty()) static_cast<void>(addGrown(editor, added));
  std::ranges::sort(changed);
  return changed;
}

} // namespace espalier
