#include "core/skeleton/finding.h"

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

std::string counted(double count, const std::string& one, const std::string& many) {
  const auto whole = std::llround(count);
  return std::to_string(whole) + ' ' + (whole == 1 ? one : many);
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

std::string describe(const Finding& finding, const Skeleton& skeleton,
                     const std::function<std::string(double)>& length) {
  const std::string node = nameOf(finding.node);
  const std::string other = finding.others.empty() ? "" : nameOf(finding.others.front());
  switch (finding.kind) {
  case Kind::separatePiece:
    return node + " is the root of a separate piece of " + counted(finding.amount, "node", "nodes");
  case Kind::twoSuccessors:
    return node + " has " + counted(finding.amount, "successor", "successors") +
           ": an axis continues once";
  case Kind::loneBranch:
    return "an axis begins at " + node + ", though nothing else goes on from " + other;
  case Kind::noLength:
    return node + " lies on its parent: the edge has no length";
  case Kind::duplicatedEdge:
    return "the edge to " + node + " lies on the one to " + other;
  case Kind::sharpTurn: {
    const std::string degrees =
        std::to_string(std::llround(finding.amount * 180 / std::numbers::pi)) + "°";
    const Node& at = skeleton[finding.node];
    return at.parent && at.edge == EdgeType::branching
               ? "the branch that begins at " + node + " turns back by " + degrees
               : "the axis turns by " + degrees + " at " + node;
  }
  case Kind::crossing:
    return node + " and " + other + " touch, but are not of one branch: " + length(finding.amount) +
           " apart";
  case Kind::loop:
    return "the axis that ends at " + node + " comes back onto the wood at " + other;
  case Kind::radiusAboveParent:
    if (const std::optional<NodeId> parent = skeleton[finding.node].parent)
      return node + " is thicker than its parent: radius " + length(skeleton[finding.node].radius) +
             " on " + length(skeleton[*parent].radius);
    return node + " is thicker than its parent";
  case Kind::edgesWithoutPoints:
    return length(finding.amount) + " from " + node + " on are far from any point";
  case Kind::noOwnPoints:
    return "the branch at " + node + " has no points of its own along its first " +
           length(finding.amount);
  case Kind::besidePoints:
    return "the wood at " + node + " lies " + length(finding.amount) + " beside its points";
  case Kind::shortFoot:
    return "the points of the stem go on by " + length(finding.amount) + " below " + node;
  case Kind::unexplainedPoints:
    return "bare twig, " + counted(finding.amount, "point", "points") + ", " +
           length(2 * finding.reach) + " long, near " + node;
  }
  return {};
}

std::string describe(const Finding& finding, const Skeleton& skeleton) {
  return describe(finding, skeleton, plainLength);
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
