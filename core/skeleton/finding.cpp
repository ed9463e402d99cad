#include "core/skeleton/finding.h"

#include "core/base/shown_message.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace espalier {
namespace {

using Kind = Finding::Kind;

std::string plainLength(double length) {
  std::ostringstream text;
  text.precision(4);
  text << length;
  return text.str();
}

std::string plainCount(std::size_t count) {
  return std::to_string(count);
}

} // namespace

std::vector<NodeId> nodesOf(const Finding& finding) {
  std::vector<NodeId> nodes = {finding.node};
  nodes.insert(nodes.end(), finding.others.begin(), finding.others.end());
  return nodes;
}

void place(Finding& finding, const PointCloud& cloud) {
  finding.place.setZero();
  for (const Eigen::Index point : finding.points)
    finding.place += cloud.position(point) / static_cast<double>(finding.points.size());
  finding.reach = 0;
  for (const Eigen::Index point : finding.points)
    finding.reach = std::max(finding.reach, (cloud.position(point) - finding.place).norm());
}

Eigen::AlignedBox3d boundsOf(const Finding& finding, const Skeleton& skeleton) {
  Eigen::AlignedBox3d box;
  for (const NodeId id : nodesOf(finding)) {
    box.extend(skeleton[id].position);
    if (skeleton[id].parent) box.extend(skeleton[*skeleton[id].parent].position);
  }
  if (!finding.points.empty()) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(finding.reach);
    box.extend(Eigen::AlignedBox3d(finding.place - reach, finding.place + reach));
  }
  return box;
}

bool isSame(const Finding& a, const Finding& b) {
  if (a.kind != b.kind) return false;
  if (a.kind == Kind::unexplainedPoints)
    return (a.place - b.place).norm() <= std::min(a.reach, b.reach);
  const auto isOf = [](NodeId id, const Finding& finding) {
    return id == finding.node || std::ranges::find(finding.others, id) != finding.others.end();
  };
  if (a.kind != Kind::crossing && a.kind != Kind::loop) return a.node == b.node;
  return isOf(a.node, b) && isOf(b.node, a);
}

ShownMessage describe(const Finding& finding, const Skeleton& skeleton,
                      const FindingNumbers& numbers) {
  const auto& length = numbers.length;
  const std::string node = std::to_string(indexOf(finding.node));
  const std::string other =
      finding.others.empty() ? "" : std::to_string(indexOf(finding.others.front()));
  const std::string count = numbers.count(static_cast<std::size_t>(finding.amount));
  const bool isOne = count == "1";
  switch (finding.kind) {
  case Kind::separatePiece:
    if (isOne) return {Shown::tr("node %1 is the root of a separate piece of 1 node"), {node}};
    return {Shown::tr("node %1 is the root of a separate piece of %2 nodes"), {node, count}};
  case Kind::twoSuccessors:
    return {Shown::tr("node %1 has %2 successors: an axis continues once"), {node, count}};
  case Kind::loneBranch:
    return {Shown::tr("an axis begins at node %1, though nothing else goes on from node %2"),
            {node, other}};
  case Kind::noLength:
    return {Shown::tr("node %1 lies on its parent: the edge has no length"), {node}};
  case Kind::duplicatedEdge:
    return {Shown::tr("the edge to node %1 lies on the one to node %2"), {node, other}};
  case Kind::sharpTurn: {
    const std::string degrees =
        std::to_string(std::llround(finding.amount * 180 / std::numbers::pi));
    const Node& at = skeleton[finding.node];
    if (at.parent && at.edge == EdgeType::branching)
      return {Shown::tr("the branch that begins at node %1 turns back by %2°"), {node, degrees}};
    return {Shown::tr("the axis turns by %2° at node %1"), {node, degrees}};
  }
  case Kind::crossing:
    return {Shown::tr("node %1 and node %2 touch, but are not of one branch: %3 apart"),
            {node, other, length(finding.amount)}};
  case Kind::loop:
    return {Shown::tr("the axis that ends at node %1 comes back onto the wood at node %2"),
            {node, other}};
  case Kind::radiusAboveParent:
    if (const std::optional<NodeId> parent = skeleton[finding.node].parent)
      return {Shown::tr("node %1 is thicker than its parent: radius %2 on %3"),
              {node, length(skeleton[finding.node].radius), length(skeleton[*parent].radius)}};
    return {Shown::tr("node %1 is thicker than its parent"), {node}};
  case Kind::edgesWithoutPoints:
    return {Shown::tr("%2 from node %1 on are far from any point"), {node, length(finding.amount)}};
  case Kind::noOwnPoints:
    return {Shown::tr("the branch at node %1 has no points of its own along its first %2"),
            {node, length(finding.amount)}};
  case Kind::besidePoints:
    return {Shown::tr("node %1 lies %2 beside its points"), {node, length(finding.amount)}};
  case Kind::shortFoot:
    return {Shown::tr("the points of the stem go on by %2 below node %1"),
            {node, length(finding.amount)}};
  case Kind::unexplainedPoints:
    if (isOne)
      return {Shown::tr("bare twig, 1 point, %2 long, near node %1"),
              {node, length(2 * finding.reach)}};
    return {Shown::tr("bare twig, %3 points, %2 long, near node %1"),
            {node, length(2 * finding.reach), count}};
  }
  return {};
}

std::string describe(const Finding& finding, const Skeleton& skeleton) {
  return inEnglish(describe(finding, skeleton, {plainLength, plainCount}));
}

std::string nameOf(Kind kind) {
  switch (kind) {
  case Kind::separatePiece:
    return "separate_piece";
  case Kind::twoSuccessors:
    return "two_successors";
  case Kind::loneBranch:
    return "lone_branch";
  case Kind::noLength:
    return "no_length";
  case Kind::duplicatedEdge:
    return "duplicated_edge";
  case Kind::sharpTurn:
    return "sharp_turn";
  case Kind::crossing:
    return "crossing";
  case Kind::loop:
    return "loop";
  case Kind::radiusAboveParent:
    return "radius_above_parent";
  case Kind::edgesWithoutPoints:
    return "edges_without_points";
  case Kind::noOwnPoints:
    return "no_own_points";
  case Kind::besidePoints:
    return "beside_points";
  case Kind::shortFoot:
    return "short_foot";
  case Kind::unexplainedPoints:
    return "unexplained_points";
  }
  return {};
}

} // namespace espalier
