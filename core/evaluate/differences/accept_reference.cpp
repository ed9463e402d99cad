#include "core/evaluate/differences/accept_reference.h"

#include "core/base/shown_message.h"
#include "core/skeleton/edits.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

void requireThere(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  for (const NodeId id : nodes)
    if (!skeleton.contains(id))
      throw ShownError({Shown::tr(
          "this part has been edited since it was compared: wait until it is compared again")});
}

std::size_t carriedNodes(const Skeleton& skeleton, NodeId id) {
  std::vector<NodeId> nodes = {id};
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes.insert(nodes.end(), skeleton.children(nodes[i]).begin(),
                 skeleton.children(nodes[i]).end());
  return nodes.size();
}

/// A foot that was added is the root of what stood without it: no tree is left beside it.
void joinToFoot(SkeletonEditor& editor, double tolerance, NodeId foot) {
  const Skeleton& skeleton = editor.skeleton();
  std::vector<NodeId> others = skeleton.roots();
  std::erase(others, foot);
  if (others.empty()) return;
  const NodeId rest =
      *std::ranges::max_element(others, {}, [&](NodeId id) { return carriedNodes(skeleton, id); });
  const Eigen::Vector3d place = skeleton[rest].position;
  const NodeId host = nearestIn(skeleton, {foot}, place);
  editor.reparent(rest, nodeAt(editor, host, place, tolerance), EdgeType::branching);
}

std::vector<NodeId> copyMissed(SkeletonEditor& editor, const Differences& found,
                               const Skeleton& reference, const DifferingPart& part,
                               Copied copied) {
  const Skeleton& skeleton = editor.skeleton();
  const std::size_t trees = skeleton.roots().size();
  const bool isFoot = !reference[part.nodes.front()].parent;
  std::optional<NodeId> host = part.host;
  if (host)
    requireThere(skeleton, {*host});
  else if (!isFoot) // it is attached to an edge so long that none of its nodes stands near
    host = nearestIn(skeleton, skeleton.roots(), part.place);
  if (host) host = nodeAt(editor, *host, part.place, found.tolerance);
  Graft graft(editor, found, reference, copied);
  for (const NodeId id : part.nodes)
    graft.copy(id, id == part.nodes.front() ? host : std::nullopt);
  for (const NodeId id : part.nodes)
    graft.goOnAbove(id);
  // A reference of more trees may add one.
  if (isFoot && skeleton.roots().size() > trees && trees >= reference.roots().size())
    joinToFoot(editor, found.tolerance, graft.added().front());
  return graft.added();
}

/// What of a part does not end on the reference: only the path there is invented.
std::vector<NodeId> inventedNodes(const Differences& found, const DifferingPart& part) {
  std::vector<NodeId> invented;
  for (const NodeId id : part.nodes)
    if (found.standsOn[indexOf(id)].empty()) invented.push_back(id);
  return invented;
}

/// Attaches what an invented part carries where the reference has it, if that has a place for it.
void attachCarried(SkeletonEditor& editor, const Differences& found, const Skeleton& reference,
                   const std::vector<NodeId>& invented, Copied copied) {
  const Skeleton& skeleton = editor.skeleton();
  std::vector<bool> isInvented(skeleton.idEnd(), false);
  for (const NodeId id : invented)
    isInvented[indexOf(id)] = true;
  const auto isLeft = [&](NodeId id) {
    return indexOf(id) < isInvented.size() && isInvented[indexOf(id)];
  };
  std::vector<NodeId> carried;
  for (const NodeId id : invented)
    std::ranges::copy_if(skeleton.children(id), std::back_inserter(carried),
                         [&](NodeId child) { return !isLeft(child); });
  Graft graft(editor, found, reference, copied);
  for (const NodeId id : carried)
    if (const auto hold = graft.standing().below(id, isLeft)) graft.attachAlong(id, *hold);
}

std::vector<NodeId> removeInvented(SkeletonEditor& editor, const Differences& found,
                                   const Skeleton& reference, const DifferingPart& part,
                                   Copied copied) {
  const Skeleton& skeleton = editor.skeleton();
  requireThere(skeleton, part.nodes);
  const std::size_t trees = skeleton.roots().size();
  const std::optional<NodeId> below = skeleton[part.nodes.front()].parent;
  const std::vector<NodeId> invented = inventedNodes(found, part);
  if (invented.empty())
    throw ShownError({Shown::tr("what is attached here is of the reference: accept what was missed "
                                "beside it, or attach it elsewhere")});
  attachCarried(editor, found, reference, invented, copied);
  for (std::size_t i = invented.size(); i-- > 0;) // children first
    if (skeleton.contains(invented[i])) removeNode(editor, invented[i]);
  if (skeleton.roots().size() > std::max<std::size_t>(trees, 1))
    throw ShownError({Shown::tr("without this the plant would fall into several trees: attach "
                                "elsewhere what it carries, or add what was missed below first")});
  return below && skeleton.contains(*below) ? std::vector{*below} : std::vector<NodeId>();
}

std::vector<NodeId> attachRight(SkeletonEditor& editor, const Differences& found,
                                const Skeleton& reference, const DifferingPart& part,
                                Copied copied) {
  requireThere(editor.skeleton(), {part.attached, *part.host});
  const Skeleton& skeleton = editor.skeleton();
  if (skeleton.isAncestor(part.attached, *part.host))
    throw ShownError(
        {Shown::tr("what should bear this is attached to it now: accept that part first")});
  Graft graft(editor, found, reference, copied);
  Hold right{.host = part.host, .place = part.place, .path = {}, .edge = part.edge};
  const auto along = graft.standing().below(part.attached, [](NodeId) { return false; });
  if (along && along->host && !along->path.empty()) right = *along;
  graft.attachAlong(part.attached, right);
  return {part.attached};
}

} // namespace

std::vector<NodeId> acceptReference(SkeletonEditor& editor, const Differences& found,
                                    const Skeleton& reference, const DifferingPart& part,
                                    Copied copied) {
  switch (part.kind) {
  case Difference::missed:
    return copyMissed(editor, found, reference, part, copied);
  case Difference::invented:
    return removeInvented(editor, found, reference, part, copied);
  case Difference::wronglyAttached:
    return attachRight(editor, found, reference, part, copied);
  case Difference::matched:
    break;
  }
  return {};
}

} // namespace espalier
