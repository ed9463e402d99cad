#include "app/window/review/finding_remedy.h"

#include "core/skeleton/best_successor.h"

#include <QCoreApplication>

#include <algorithm>
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
    return skeleton[finding.node].edge == EdgeType::branching ? attach : remove;
  case Kind::crossing:
  case Kind::noOwnPoints:
    return attach;
  case Kind::radiusAboveParent:
    return {"radius_down", RemedyText::tr("makes it thinner"), {finding.node}};
  case Kind::edgesWithoutPoints:
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
