#include "app/window/review/doubt_ghosts.h"

#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/path_edits.h"
#include "ui/document/doubt_text.h"

#include <algorithm>

namespace espalier {
namespace {

/// A line for each unbranched run of nodes.
std::vector<std::vector<Eigen::Vector3d>> linesOf(const Skeleton& part) {
  std::vector<std::vector<Eigen::Vector3d>> lines;
  for (const NodeId id : part.ids()) {
    const auto parent = part[id].parent;
    if (!parent || (part[*parent].parent && part.children(*parent).size() == 1)) continue;
    std::vector<Eigen::Vector3d> line = {part[*parent].position, part[id].position};
    for (NodeId at = id; part.children(at).size() == 1;) {
      at = part.children(at).front();
      line.push_back(part[at].position);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// The line of the wood in doubt, with the edge to what bears it.
std::vector<Eigen::Vector3d> woodOf(const Skeleton& skeleton, const Doubt& doubt) {
  std::vector<Eigen::Vector3d> line;
  if (doubt.nodes.empty()) return line;
  if (const auto foot = skeleton[doubt.node].parent) line.push_back(skeleton[*foot].position);
  for (const NodeId id : doubt.nodes)
    line.push_back(skeleton[id].position);
  return line;
}

/// An alternative as it is drawn, without a number.
ShownGhost ghostOf(const Skeleton& skeleton, const Doubt& doubt, const Alternative& one) {
  const auto place = [&](NodeId id) { return skeleton[id].position; };
  ShownGhost ghost;
  const bool hasOthers = std::ranges::any_of(
      doubt.alternatives, [](const Alternative& each) { return each.onto.has_value(); });
  switch (one.kind) {
  case Alternative::Kind::asItIs: {
    ghost.look = ShownGhost::Look::present;
    std::vector<Eigen::Vector3d> line = woodOf(skeleton, doubt);
    if (hasOthers && line.size() > 2) line.resize(2); // where it is attached
    if (!line.empty()) ghost.lines.push_back(std::move(line));
    break;
  }
  case Alternative::Kind::remove: {
    ghost.look = ShownGhost::Look::removed;
    ghost.lines.push_back(woodOf(skeleton, doubt));
    break;
  }
  case Alternative::Kind::attach:
    ghost.lines.push_back({place(*one.onto), place(doubt.node)});
    break;
  case Alternative::Kind::add:
    ghost.lines = linesOf(one.branch->part);
    break;
  }
  return ghost;
}

} // namespace

std::vector<ShownGhost> ghostsOf(const Skeleton& skeleton, const Doubt& doubt) {
  std::vector<ShownGhost> ghosts;
  for (const std::size_t i : numbered(doubt)) {
    ghosts.push_back(ghostOf(skeleton, doubt, doubt.alternatives[i]));
    ghosts.back().number = static_cast<int>(ghosts.size());
  }
  return ghosts;
}

std::vector<ShownGhost> ghostsOfLikeliest(const Skeleton& skeleton,
                                          const std::vector<Doubt>& doubts) {
  std::vector<ShownGhost> ghosts;
  for (const Doubt& doubt : doubts)
    ghosts.push_back(ghostOf(skeleton, doubt, doubt.alternatives.front()));
  return ghosts;
}

Sight sightOf(const Skeleton& skeleton, const Doubt& doubt) {
  Sight sight{.nodes = doubt.nodes};
  if (sight.nodes.empty()) sight.nodes.push_back(doubt.node);
  const bool isAttachment = doubt.kind == Doubt::Kind::attachment;
  constexpr std::size_t meant = 3; // of wood that may grow elsewhere: its foot says from where
  if (isAttachment && sight.nodes.size() > meant) sight.nodes.resize(meant);
  Eigen::AlignedBox3d box;
  for (const Alternative& one : doubt.alternatives) {
    if (isAttachment && one.kind == Alternative::Kind::remove) continue; // it is all of the wood
    const ShownGhost ghost = ghostOf(skeleton, doubt, one);
    std::vector<Eigen::Vector3d> all;
    for (const std::vector<Eigen::Vector3d>& line : ghost.lines)
      for (const Eigen::Vector3d& place : line) {
        all.push_back(place);
        sight.places.push_back(place);
        box.extend(place);
      }
    const bool isOther = one.kind == Alternative::Kind::attach ||
                         (one.kind == Alternative::Kind::asItIs && !all.empty());
    if (isOther) sight.apart.push_back(std::move(all));
  }
  for (const NodeId id : sight.nodes)
    box.extend(skeleton[id].position);
  sight.margin = std::max(box.diagonal().norm() / 2, 2 * meanEdgeLength(skeleton));
  return sight;
}

ShownGhost ghostOfPoints(const Skeleton& skeleton, const Doubt& doubt,
                         const PointDistances& distances, double near) {
  const std::vector<float>& toSurface = distances.toSurface();
  std::vector<bool> isOfWood(skeleton.idEnd(), false); // by id
  for (const NodeId id : doubt.nodes)
    isOfWood[indexOf(id)] = true;
  std::optional<EdgeIndex> added;
  Eigen::AlignedBox3d box;
  for (const Alternative& one : doubt.alternatives) {
    if (one.kind != Alternative::Kind::add) continue;
    added.emplace(one.branch->part);
    for (const NodeId id : one.branch->part.ids())
      box.extend(one.branch->part[id].position);
  }
  if (added) box = {box.min().array() - near, box.max().array() + near};
  ShownGhost ghost{.look = ShownGhost::Look::present};
  for (std::size_t i = 0; i < toSurface.size(); ++i) {
    const auto placeOf = [&] { return distances.cloud()->position(static_cast<Eigen::Index>(i)); };
    if (added) {
      if (toSurface[i] <= near / 2) continue; // it has wood
      const Eigen::Vector3d place = placeOf();
      if (!box.contains(place)) continue;
      if (const auto nearest = added->nearest(place); nearest && nearest->distance <= near)
        ghost.lines.push_back({place});
    } else if (toSurface[i] <= near && indexOf(distances.nearest()[i]) < isOfWood.size() &&
               isOfWood[indexOf(distances.nearest()[i])]) {
      ghost.lines.push_back({placeOf()});
    }
  }
  return ghost;
}

std::vector<NodeId> woodSeenWith(const Skeleton& skeleton, const Doubt& doubt) {
  constexpr int around = 4; // nodes of its axis below, and as many above
  std::vector<NodeId> nodes = sightOf(skeleton, doubt).nodes;
  const auto addAround = [&](NodeId id) {
    std::optional<NodeId> at = id;
    for (int i = 0; i <= around && at; ++i, at = previousOnAxis(skeleton, *at))
      nodes.push_back(*at);
    at = nextOnAxis(skeleton, id);
    for (int i = 0; i < around && at; ++i, at = nextOnAxis(skeleton, *at))
      nodes.push_back(*at);
  };
  for (const Alternative& one : doubt.alternatives) {
    if (one.onto) addAround(*one.onto);
    if (one.branch) addAround(one.branch->on);
  }
  return nodes;
}

} // namespace espalier
