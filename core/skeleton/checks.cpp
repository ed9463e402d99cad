#include "core/skeleton/checks.h"

#include "core/base/box_tree.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/crossings.h"
#include "core/skeleton/path_edits.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

using Kind = Finding::Kind;

double lengthOfEdge(const Skeleton& skeleton, NodeId id) { // pre: it has a parent
  return (skeleton[id].position - skeleton[*skeleton[id].parent].position).norm();
}

std::vector<Finding> separatePieces(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  const std::vector<NodeId> roots = skeleton.roots();
  if (roots.size() < 2) return {};
  std::vector<std::size_t> carried(skeleton.idEnd(), 1);
  for (auto id = ids.rbegin(); id != ids.rend(); ++id)
    if (const auto parent = skeleton[*id].parent)
      carried[indexOf(*parent)] += carried[indexOf(*id)];
  const NodeId largest =
      *std::ranges::max_element(roots, {}, [&](NodeId root) { return carried[indexOf(root)]; });
  std::vector<Finding> findings;
  for (const NodeId root : roots)
    if (root != largest)
      findings.push_back({.kind = Kind::separatePiece,
                          .node = root,
                          .amount = static_cast<double>(carried[indexOf(root)])});
  return findings;
}

std::vector<Finding> secondSuccessors(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<Finding> findings;
  for (const NodeId id : ids) {
    Finding finding{.kind = Kind::twoSuccessors, .node = id};
    for (const NodeId child : skeleton.children(id))
      if (skeleton[child].edge == EdgeType::successor) finding.others.push_back(child);
    finding.amount = static_cast<double>(finding.others.size());
    if (finding.others.size() > 1) findings.push_back(std::move(finding));
  }
  return findings;
}

std::vector<Finding> loneBranches(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<Finding> findings;
  for (const NodeId id : ids) {
    const Node& node = skeleton[id];
    if (node.parent && node.edge == EdgeType::branching &&
        skeleton.children(*node.parent).size() == 1)
      findings.push_back({.kind = Kind::loneBranch, .node = id, .others = {*node.parent}});
  }
  return findings;
}

std::vector<Finding> edgesWithoutLength(const Skeleton& skeleton, const std::vector<NodeId>& ids,
                                        double shortest) {
  std::vector<Finding> findings;
  for (const NodeId id : ids)
    if (skeleton[id].parent && lengthOfEdge(skeleton, id) <= shortest)
      findings.push_back({.kind = Kind::noLength, .node = id});
  return findings;
}

/// Whether the ends of two edges lie within `tolerance` [L], one way round or the other.
bool haveSameEnds(const Skeleton& skeleton, NodeId a, NodeId b, double tolerance) {
  const auto near = [&](NodeId one, NodeId other) {
    return (skeleton[one].position - skeleton[other].position).norm() <= tolerance;
  };
  const NodeId underA = *skeleton[a].parent;
  const NodeId underB = *skeleton[b].parent;
  return (near(a, b) && near(underA, underB)) || (near(a, underB) && near(underA, b));
}

std::vector<Finding> duplicatedEdges(const Skeleton& skeleton, const std::vector<NodeId>& ids,
                                     double shortest, double share) {
  std::vector<NodeId> edges;
  std::vector<Eigen::AlignedBox3d> middles;
  for (const NodeId id : ids) {
    if (!skeleton[id].parent || lengthOfEdge(skeleton, id) <= shortest) continue;
    edges.push_back(id);
    middles.emplace_back(
        Eigen::Vector3d((skeleton[id].position + skeleton[*skeleton[id].parent].position) / 2));
  }
  const BoxTree tree(middles);
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double own = lengthOfEdge(skeleton, edges[i]);
    std::size_t first = i; // that it lies on
    tree.within(middles[i], share * own, [&](std::size_t k) {
      const double tolerance = share * std::min(own, lengthOfEdge(skeleton, edges[k]));
      if (k < first && haveSameEnds(skeleton, edges[i], edges[k], tolerance)) first = k;
    });
    if (first != i)
      findings.push_back(
          {.kind = Kind::duplicatedEdge, .node = edges[i], .others = {edges[first]}});
  }
  return findings;
}

std::vector<Finding> sharpTurns(const Skeleton& skeleton, const std::vector<NodeId>& ids,
                                double shortest, double limit) {
  std::vector<Finding> findings;
  for (const NodeId id : ids) {
    const Node& node = skeleton[id];
    if (!node.parent || node.edge != EdgeType::successor) continue;
    const std::optional<NodeId> next = nextOnAxis(skeleton, id);
    if (!next) continue;
    const Eigen::Vector3d before = node.position - skeleton[*node.parent].position;
    const Eigen::Vector3d after = skeleton[*next].position - node.position;
    if (before.norm() <= shortest || after.norm() <= shortest) continue;
    const double turn = std::atan2(before.cross(after).norm(), before.dot(after));
    if (turn > limit)
      findings.push_back({.kind = Kind::sharpTurn, .node = id, .others = {*next}, .amount = turn});
  }
  return findings;
}

std::vector<Finding> thickOnThin(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<Finding> findings;
  for (const NodeId id : ids) {
    const Node& node = skeleton[id];
    constexpr double rounding = 1 + 1e-9;
    if (node.parent && node.radius > skeleton[*node.parent].radius * rounding)
      findings.push_back({.kind = Kind::radiusAboveParent, .node = id, .amount = node.radius});
  }
  return findings;
}

} // namespace

std::vector<Finding> check(const Skeleton& skeleton, double spacing, const CheckOptions& options) {
  const std::vector<NodeId> ids = skeleton.ids();
  const double shortest = options.shortEdge * meanEdgeLength(skeleton);
  std::vector<Finding> findings;
  const auto append = [&](std::vector<Finding> more) {
    std::ranges::move(more, std::back_inserter(findings));
  };
  append(separatePieces(skeleton, ids));
  append(secondSuccessors(skeleton, ids));
  append(loneBranches(skeleton, ids));
  append(edgesWithoutLength(skeleton, ids, shortest));
  append(duplicatedEdges(skeleton, ids, shortest, options.duplicateShare));
  append(sharpTurns(skeleton, ids, shortest, options.sharpTurn));
  append(crossings(skeleton, spacing, options));
  append(thickOnThin(skeleton, ids));
  return findings;
}

} // namespace espalier
