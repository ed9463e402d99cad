#include "core/skeleton/branch_edits.h"

#include "core/base/shown_message.h"
#include "core/skeleton/edits.h"

#include <algorithm>
#include <cassert>

namespace espalier {
namespace {

void requireArms(const Skeleton& skeleton, NodeId a, NodeId b) {
  for (const NodeId id : {a, b})
    if (!skeleton[id].parent)
      throw ShownError({Shown::tr("node %1 is a root, attached to nothing: choose a node above it"),
                        {std::to_string(indexOf(id))}});
  if (skeleton[a].parent == skeleton[b].parent)
    throw ShownError(
        {Shown::tr(
             "node %1 and node %2 are attached to the same node: there is nothing to exchange"),
         {std::to_string(indexOf(a)), std::to_string(indexOf(b))}});
  if (skeleton.isAncestor(a, b) || skeleton.isAncestor(b, a))
    throw ShownError({Shown::tr("of node %1 and node %2 one carries the other: choose arms of two "
                                "branches that cross"),
                      {std::to_string(indexOf(a)), std::to_string(indexOf(b))}});
}

} // namespace

NodeId addBranch(SkeletonEditor& editor, std::optional<NodeId> parent,
                 const std::vector<Eigen::Vector3d>& places, const std::vector<double>& radii) {
  assert(!places.empty() && places.size() == radii.size());
  const double thickest = parent ? editor.skeleton()[*parent].radius : 0;
  std::optional<NodeId> last = parent;
  double radius = thickest;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (radii[i] > 0) radius = thickest > 0 ? std::min(radii[i], thickest) : radii[i];
    const EdgeType edge = last ? edgeOfNewChild(editor.skeleton(), *last) : EdgeType::successor;
    const RadiusSource source = radii[i] > 0 ? RadiusSource::measured : RadiusSource::extrapolated;
    last = editor.add({.position = places[i],
                       .radius = radius,
                       .parent = last,
                       .edge = edge,
                       .origin = {.source = source}});
  }
  return *last;
}

void replaceCarried(SkeletonEditor& editor, NodeId id, const Skeleton& part) {
  assert(part.roots().size() == 1);
  const std::vector<NodeId> carried = editor.skeleton().children(id);
  for (const NodeId child : carried)
    removeSubtree(editor, child);
  std::vector<NodeId> copies(part.idEnd(), id);
  for (const NodeId from : part.ids()) { // parents before their children
    Node copy = part[from];
    if (!copy.parent) continue;
    copy.parent = copies[indexOf(*copy.parent)];
    copies[indexOf(from)] = editor.add(copy);
  }
}

std::vector<NodeId> addCarried(SkeletonEditor& editor, NodeId id, const Skeleton& part) {
  assert(part.roots().size() == 1);
  const NodeId root = part.roots().front();
  std::vector<NodeId> copies(part.idEnd(), id);
  std::vector<NodeId> first;
  for (const NodeId from : part.ids()) { // parents before their children
    Node copy = part[from];
    if (from == root) continue;
    const bool isFirst = *copy.parent == root;
    if (isFirst) copy.edge = edgeOfNewChild(editor.skeleton(), id);
    copy.parent = copies[indexOf(*copy.parent)];
    copies[indexOf(from)] = editor.add(copy);
    if (isFirst) first.push_back(copies[indexOf(from)]);
  }
  return first;
}

void exchangeArms(SkeletonEditor& editor, NodeId a, NodeId b) {
  requireArms(editor.skeleton(), a, b);
  const Node first = editor.skeleton()[a];
  const Node second = editor.skeleton()[b];
  editor.makeRoot(a); // for a moment no node has two successors
  editor.reparent(b, *first.parent, first.edge);
  editor.reparent(a, *second.parent, second.edge);
}

} // namespace espalier
