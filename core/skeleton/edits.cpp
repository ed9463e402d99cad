#include "core/skeleton/edits.h"

#include "core/base/shown_message.h"
#include "core/skeleton/keep_units.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace espalier {
namespace {

bool isSuccessor(const Skeleton& skeleton, NodeId id) {
  return skeleton[id].edge == EdgeType::successor;
}

void requireParent(const Skeleton& skeleton, NodeId id) {
  if (!skeleton[id].parent)
    throw ShownError(
        {Shown::tr("node %1 is a root and has no edge to a parent: choose a node above it"),
         {std::to_string(indexOf(id))}});
}

void removeRoot(SkeletonEditor& editor, NodeId root) {
  const std::vector<NodeId> children = editor.skeleton().children(root); // successor first
  const bool oneFollows =
      children.size() == 1 || (!children.empty() && isSuccessor(editor.skeleton(), children[0]));
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (i == 0 || !oneFollows)
      editor.makeRoot(children[i]);
    else
      editor.reparent(children[i], children[0], EdgeType::branching);
  }
}

} // namespace

EdgeType edgeOfNewChild(const Skeleton& skeleton, NodeId parent, std::optional<NodeId> except) {
  for (const NodeId child : skeleton.children(parent))
    if (child != except && isSuccessor(skeleton, child)) return EdgeType::branching;
  return EdgeType::successor;
}

void moveNode(SkeletonEditor& editor, NodeId id, const Eigen::Vector3d& position) {
  editor.setPosition(id, position);
}

void moveAll(SkeletonEditor& editor, const Eigen::Vector3d& shift) {
  for (const NodeId id : editor.skeleton().ids())
    editor.setPosition(id, editor.skeleton()[id].position + shift);
}

NodeId addChild(SkeletonEditor& editor, NodeId parent, const Eigen::Vector3d& position) {
  return editor.add({.position = position,
                     .radius = editor.skeleton()[parent].radius,
                     .parent = parent,
                     .edge = edgeOfNewChild(editor.skeleton(), parent)});
}

NodeId splitEdge(SkeletonEditor& editor, NodeId id, double fraction) {
  assert(fraction >= 0 && fraction <= 1);
  requireParent(editor.skeleton(), id);
  const Node below = editor.skeleton()[*editor.skeleton()[id].parent];
  const Node above = editor.skeleton()[id];
  const NodeId between =
      editor.add({.position = below.position + fraction * (above.position - below.position),
                  .radius = below.radius + fraction * (above.radius - below.radius),
                  .parent = above.parent,
                  .edge = above.edge,
                  .origin = above.origin});
  editor.reparent(id, between, EdgeType::successor);
  if (above.isMarked) {
    editor.setMarked(between, true);
    editor.setMarked(id, false);
  }
  if (above.entities.size() < 2) return between; // no unit starts there
  std::vector<Entity> units = above.entities;
  const Entity own = std::exchange(
      units.back(), {above.entities.back().scale, above.entities.back().symbol, std::nullopt});
  editor.setEntities(between, std::move(units));
  editor.setEntities(id, {own});
  return between;
}

void removeNode(SkeletonEditor& editor, NodeId id) {
  const Node node = editor.skeleton()[id];
  const std::vector<NodeId> children = editor.skeleton().children(id); // successor first
  if (!node.parent) {
    removeRoot(editor, id);
  } else {
    for (std::size_t i = 0; i < children.size(); ++i) {
      const bool follows = i == 0 && isSuccessor(editor.skeleton(), children[i]);
      editor.reparent(children[i], *node.parent, follows ? node.edge : EdgeType::branching);
    }
  }
  passOnUnits(editor, node.entities, children);
  if (node.isMarked && !children.empty()) editor.setMarked(children.front(), true);
  editor.erase(id);
}

void removeSubtree(SkeletonEditor& editor, NodeId id) {
  std::vector<NodeId> carried = {id};
  for (std::size_t next = 0; next < carried.size(); ++next) {
    const std::vector<NodeId>& children = editor.skeleton().children(carried[next]);
    carried.insert(carried.end(), children.begin(), children.end());
  }
  for (auto at = carried.rbegin(); at != carried.rend(); ++at)
    editor.erase(*at);
}

void reparentNode(SkeletonEditor& editor, NodeId id, NodeId parent) {
  if (editor.skeleton()[id].parent == parent) return;
  editor.reparent(id, parent, edgeOfNewChild(editor.skeleton(), parent, id));
}

void setEdgeType(SkeletonEditor& editor, NodeId id, EdgeType type) {
  requireParent(editor.skeleton(), id);
  if (type == EdgeType::successor) {
    const std::vector<NodeId> siblings = editor.skeleton().children(*editor.skeleton()[id].parent);
    for (const NodeId sibling : siblings)
      if (sibling != id && isSuccessor(editor.skeleton(), sibling))
        editor.setEdge(sibling, EdgeType::branching);
  }
  editor.setEdge(id, type);
}

void replaceSkeleton(SkeletonEditor& editor, const Skeleton& by) {
  const std::vector<NodeId> old = editor.skeleton().ids();
  for (auto at = old.rbegin(); at != old.rend(); ++at)
    editor.erase(*at);

  std::vector<std::optional<NodeId>> copies(by.idEnd());
  std::vector<NodeId> waiting; // nodes copied before their parents
  for (std::size_t i = 0; i < by.idEnd(); ++i) {
    const NodeId id{static_cast<std::uint32_t>(i)};
    if (!by.contains(id)) continue;
    Node copy = by[id];
    if (copy.parent) {
      if (!copies[indexOf(*copy.parent)]) waiting.push_back(id);
      copy.parent = copies[indexOf(*copy.parent)];
    }
    copies[i] = editor.add(copy);
  }
  for (const NodeId id : waiting)
    editor.reparent(*copies[indexOf(id)], *copies[indexOf(*by[id].parent)], by[id].edge);
}

} // namespace espalier
