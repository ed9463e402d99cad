#include "core/skeleton/checks.h"

#include "core/base/box_tree.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/crossings.h"
#include "core/skeleton/frustum.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/path_edits.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace espalier {
namespace {

using Kind = Finding::Kind;

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
    if (skeleton[id].parent && edgeLength(skeleton, id) <= shortest)
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
  std::vector<double> lengths;
  std::vector<Eigen::AlignedBox3d> middles;
  for (const NodeId id : ids) {
    const double length = edgeLength(skeleton, id);
    if (length <= shortest) continue;
    edges.push_back(id);
    lengths.push_back(length);
    middles.emplace_back(
        Eigen::Vector3d((skeleton[id].position + skeleton[*skeleton[id].parent].position) / 2));
  }
  const BoxTree tree(middles);
  constexpr std::size_t mostKnown = 8;
  std::deque<std::size_t> lainOn; // the last edges that others lie on
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto isSame = [&](std::size_t k) {
      const double tolerance = share * std::min(lengths[i], lengths[k]);
      return haveSameEnds(skeleton, edges[i], edges[k], tolerance);
    };
    // Where thousands lie on each other, most lie on one that others did.
    const auto known = std::ranges::find_if(lainOn, isSame);
    std::size_t first = known != lainOn.end() ? *known : i; // that it lies on
    // Those that lie nearest come first: where a million leave one node, too many lie near.
    const double most = share * lengths[i];
    for (double reach = most / 64; first == i; reach *= 4) {
      tree.within(middles[i], reach, [&](std::size_t k) {
        if (k < first && isSame(k)) first = k;
      });
      if (!(reach > 0 && 4 * reach <= most)) break; // also of a share of 0
    }
    if (first == i) continue;
    findings.push_back({.kind = Kind::duplicatedEdge, .node = edges[i], .others = {edges[first]}});
    if (known == lainOn.end()) lainOn.push_front(first);
    if (lainOn.size() > mostKnown) lainOn.pop_back();
  }
  return findings;
}

double turn(const Eigen::Vector3d& before, const Eigen::Vector3d& after) {
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

/// The turns of edges that have a length.
class Turns {
public:
  Turns(const Skeleton& skeleton, double shortest, double spacing)
      : skeleton_(skeleton), shortest_(shortest), spacing_(spacing) {}

  /// From the edge to a node to the next one of its axis, 0 if there is none.
  [[nodiscard]] double on(NodeId id) const {
    const std::optional<NodeId> next = nextOnAxis(skeleton_, id);
    return next ? between(edge(id), edge(*next)) : 0;
  }

  /// How far a branch turns from what bears it: its first edge, if that leads clear of its bearer.
  /// Else edges that begin amid wood stray, and it is the less of that and of its first few edges
  /// from a few below.
  [[nodiscard]] double off(NodeId branch) const {
    constexpr int reach = 4; // edges
    const NodeId foot = *skeleton_[branch].parent;
    const double first = between(edge(foot), edge(branch));
    if (leavesBearer(branch)) return first;
    NodeId lower = foot;
    NodeId upper = branch;
    for (int i = 0; i < reach; ++i) {
      lower = skeleton_[lower].parent.value_or(lower);
      if (i > 0) upper = nextOnAxis(skeleton_, upper).value_or(upper);
    }
    const Eigen::Vector3d place = skeleton_[foot].position;
    return std::min(first,
                    between(place - skeleton_[lower].position, skeleton_[upper].position - place));
  }

  /// Whether the first edge of a branch ends clear of the wood of its bearer, by half as much as
  /// that is thick and by some spacings of the points.
  [[nodiscard]] bool leavesBearer(NodeId branch) const {
    constexpr double spacings = 2;
    const Eigen::Vector3d place = skeleton_[branch].position;
    double left = edgeLength(skeleton_, branch);
    NodeId at = *skeleton_[branch].parent;
    const double margin = std::max(spacings * spacing_, skeleton_[at].radius / 2);
    for (left += margin; left > 0 && skeleton_[at].parent; at = *skeleton_[at].parent) {
      const Frustum body = *frustumOf(skeleton_, at);
      const double share = body.nearestShare(place);
      if ((body.at(share) - place).norm() - body.radiusAt(share) < margin) return false;
      left -= body.length();
    }
    return true;
  }

private:
  [[nodiscard]] Eigen::Vector3d edge(NodeId id) const {
    const Node& node = skeleton_[id];
    if (!node.parent) return Eigen::Vector3d::Zero();
    return node.position - skeleton_[*node.parent].position;
  }

  [[nodiscard]] double between(const Eigen::Vector3d& before, const Eigen::Vector3d& after) const {
    if (before.norm() <= shortest_ || after.norm() <= shortest_) return 0;
    return turn(before, after);
  }

  const Skeleton& skeleton_;
  double shortest_; // [L]: shorter edges have no direction
  double spacing_;  // [L]
};

std::vector<Finding> sharpTurns(const Skeleton& skeleton, const std::vector<NodeId>& ids,
                                double shortest, double spacing, const CheckOptions& options) {
  const Turns turns(skeleton, shortest, spacing);
  std::vector<Finding> findings;
  for (const NodeId id : ids) {
    const Node& node = skeleton[id];
    if (!node.parent) continue;
    const bool isBranch = node.edge == EdgeType::branching;
    const double on = turns.on(id);
    const double off = isBranch ? turns.off(id) : 0;
    const double sharpest = std::max(on, off);
    const bool isFirst = isBranch && !turns.leavesBearer(id);
    if (off <= options.branchTurn && on <= (isFirst ? options.branchTurn : options.sharpTurn))
      continue;
    const NodeId other = off == sharpest ? *node.parent : *nextOnAxis(skeleton, id);
    findings.push_back(
        {.kind = Kind::sharpTurn, .node = id, .others = {other}, .amount = sharpest});
  }
  return findings;
}

std::vector<Finding> thickOnThin(const Skeleton& skeleton, const std::vector<NodeId>& ids,
                                 double thicker) {
  std::vector<Finding> findings;
  for (const NodeId id : ids) {
    const Node& node = skeleton[id];
    if (node.parent && node.radius > skeleton[*node.parent].radius * (1 + thicker))
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
  append(sharpTurns(skeleton, ids, shortest, spacing, options));
  append(crossings(skeleton, spacing, options));
  append(thickOnThin(skeleton, ids, options.thicker));
  return findings;
}

} // namespace espalier
