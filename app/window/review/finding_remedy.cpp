#include "app/window/review/finding_remedy.h"

#include "core/skeleton/axes.h"
#include "core/skeleton/best_successor.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/edits.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace espalier {
namespace {

struct RemedyText {
  Q_DECLARE_TR_FUNCTIONS(FindingRemedy)
};

/// Whether all that the nodes carry is among them.
bool carryNoOther(const std::vector<NodeId>& nodes, const Skeleton& skeleton) {
  return std::ranges::all_of(nodes, [&](NodeId id) {
    return std::ranges::all_of(skeleton.children(id), [&](NodeId child) {
      return std::ranges::find(nodes, child) != nodes.end();
    });
  });
}

/// Of edges that lead up from a root and bear nothing beside, their lower ends: the root and what
/// follows. Empty: they are others, or all that the root carries.
std::vector<NodeId> footBelow(const std::vector<NodeId>& edges, const Skeleton& skeleton) {
  std::vector<NodeId> lower;
  for (const NodeId id : edges)
    if (const auto parent = skeleton[id].parent) lower.push_back(*parent);
  const bool isChain =
      std::ranges::all_of(lower, [&](NodeId id) { return skeleton.children(id).size() == 1; });
  const bool beginsAtRoot =
      std::ranges::any_of(lower, [&](NodeId id) { return !skeleton[id].parent.has_value(); });
  if (!isChain || !beginsAtRoot || carryNoOther(edges, skeleton)) return {};
  return lower;
}

/// The axis about a sharp turn, a few nodes on either side, with what it bears there left out.
struct AxisPart {
  Skeleton part;
  std::vector<NodeId> nodes; // of the plant, by the ids of the part
};

AxisPart axisAt(const Skeleton& skeleton, NodeId turn) {
  constexpr int reach = 6; // nodes: what removing one of them may let turn
  std::vector<NodeId> nodes = {turn};
  for (int i = 0; i < reach && skeleton[nodes.front()].parent; ++i)
    nodes.insert(nodes.begin(), *skeleton[nodes.front()].parent);
  for (int i = 0; i < reach; ++i) {
    const std::optional<NodeId> next = nextOnAxis(skeleton, nodes.back());
    if (!next) break;
    nodes.push_back(*next);
  }
  AxisPart axis{.part = {}, .nodes = nodes};
  std::optional<NodeId> last;
  for (const NodeId id : nodes) {
    Node node = skeleton[id];
    node.parent = last;
    node.edge = EdgeType::successor;
    last = axis.part.add(node);
  }
  return axis;
}

/// The node whose removal mends a turn of an axis: the one that turns, else one beside it, where
/// the axis does not turn sharply once that is gone. None does: the one that turns.
NodeId turnsWith(const Finding& finding, const Skeleton& skeleton, double spacing) {
  const AxisPart axis = axisAt(skeleton, finding.node);
  const auto mends = [&](NodeId id) {
    Skeleton without = axis.part;
    SkeletonEditor editor(without);
    removeNode(editor, NodeId(static_cast<std::uint32_t>(std::ranges::find(axis.nodes, id) -
                                                         axis.nodes.begin())));
    return std::ranges::none_of(check(without, spacing, {}), [](const Finding& one) {
      return one.kind == Finding::Kind::sharpTurn;
    });
  };
  std::vector<NodeId> candidates = {finding.node};
  // Beside it only what bears nothing else: its branches would move.
  const NodeId parent = *skeleton[finding.node].parent;
  if (skeleton.children(parent).size() == 1) candidates.push_back(parent);
  const auto next = nextOnAxis(skeleton, finding.node);
  if (next && skeleton.children(*next).size() <= 1) candidates.push_back(*next);
  const auto found = std::ranges::find_if(candidates, mends);
  return found != candidates.end() ? *found : finding.node;
}

} // namespace

Remedy remedyOf(const Finding& finding, const Skeleton& skeleton, double spacing) {
  using Kind = Finding::Kind;
  const Remedy attach{"tool_reparent", RemedyText::tr("attaches it elsewhere"), {finding.node}};
  const Remedy remove{"remove", RemedyText::tr("removes the node"), {finding.node}};
  switch (finding.kind) {
  case Kind::separatePiece:
    return {"join", RemedyText::tr("joins it to the nearest tree"), {finding.node}};
  case Kind::twoSuccessors: {
    std::vector<NodeId> branches = finding.others;
    std::erase(branches, bestSuccessor(skeleton, finding.others));
    return {"make_branching", RemedyText::tr("keeps the straightest and thickest, others branch"),
            std::move(branches)};
  }
  case Kind::loneBranch:
    return {"make_axial", RemedyText::tr("lets the axis go on"), {finding.node}};
  case Kind::noLength:
  case Kind::duplicatedEdge:
  case Kind::loop:
    return remove;
  case Kind::sharpTurn:
    if (skeleton[finding.node].edge == EdgeType::branching) return attach;
    return {remove.action, remove.does, {turnsWith(finding, skeleton, spacing)}};
  case Kind::crossing:
  case Kind::noOwnPoints:
    return attach;
  case Kind::radiusAboveParent:
    return {"radius_down", RemedyText::tr("makes it thinner"), {finding.node}};
  case Kind::edgesWithoutPoints:
    if (const std::vector<NodeId> foot = footBelow(nodesOf(finding), skeleton); !foot.empty())
      return {"remove", RemedyText::tr("removes them: the plant begins above"), foot};
    if (!carryNoOther(nodesOf(finding), skeleton)) return attach;
    return {"remove_subtree", RemedyText::tr("removes them"), {finding.node}};
  case Kind::besidePoints:
    // The nearest points of thick wood are on one side of it.
    if (skeleton[finding.node].radius > 2 * spacing)
      return {"center", RemedyText::tr("moves it to their middle"), nodesOf(finding)};
    return {"stick", RemedyText::tr("moves it to its points"), nodesOf(finding)};
  case Kind::shortFoot:
    return {"extend_foot", RemedyText::tr("moves the root down"), {finding.node}};
  case Kind::unexplainedPoints:
    break;
  }
  return {"branch_from_points", RemedyText::tr("grows a branch from them"), {finding.node}};
}

} // namespace espalier
