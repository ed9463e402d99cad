#include "core/evaluate/differences/standing_nodes.h"

#include "core/skeleton/frustum.h"
#include "core/skeleton/length_along.h"

#include <algorithm>

namespace espalier {
namespace {

/// The edge that a node was nearest to.
std::optional<NodeId> edgeOf(const Differences& found, NodeId node) {
  if (indexOf(node) >= found.standsOn.size()) return std::nullopt;
  const std::vector<NodeId>& edges = found.standsOn[indexOf(node)];
  return edges.empty() ? std::nullopt : std::optional(edges.front());
}

} // namespace

StandingNodes::StandingNodes(const Skeleton& result, const Differences& found,
                             const Skeleton& reference)
    : result_(result), found_(found), reference_(reference), standing_(reference.idEnd()) {
  for (const NodeId id : result.ids())
    if (const auto edge = edgeOf(found, id)) standing_[indexOf(*edge)].push_back(id);
  for (std::size_t i = 0; i < standing_.size(); ++i) {
    const NodeId edge{static_cast<std::uint32_t>(i)};
    std::ranges::stable_sort(standing_[i], {}, [&](NodeId id) { return share(edge, id); });
  }
}

double StandingNodes::share(NodeId edge, NodeId node) const {
  return centerLine(reference_, edge).nearestShare(result_[node].position);
}

std::optional<NodeId> StandingNodes::lowestOn(NodeId edge) const {
  const auto& nodes = standing_[indexOf(edge)];
  const auto found = std::ranges::find_if(nodes, [&](NodeId node) { return isThere(node); });
  return found == nodes.end() ? std::nullopt : std::optional(*found);
}

std::vector<NodeId> StandingNodes::nextAbove(NodeId edge) const {
  std::vector<NodeId> found;
  std::vector<NodeId> open = {edge};
  while (!open.empty()) {
    const NodeId next = open.back();
    open.pop_back();
    if (const auto lowest = lowestOn(next))
      found.push_back(*lowest);
    else
      for (const NodeId above : reference_.children(next))
        open.push_back(above);
  }
  return found;
}

std::optional<NodeId> StandingNodes::firstStanding(NodeId node) const {
  std::vector<NodeId> open = {node};
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (edgeOf(found_, open[i])) return open[i];
    const std::vector<NodeId>& children = result_.children(open[i]);
    open.insert(open.end(), children.begin(), children.end());
  }
  return std::nullopt;
}

std::optional<Hold> StandingNodes::below(NodeId attached,
                                         const std::function<bool(NodeId)>& leftOut) const {
  const std::optional<NodeId> first = firstStanding(attached);
  if (!first) return std::nullopt;
  const NodeId lowest = *edgeOf(found_, *first);
  const double from = share(lowest, *first);
  Hold hold;
  for (std::optional<NodeId> edge = lowest; edge; edge = reference_[*edge].parent) {
    const std::vector<NodeId>& nodes = standing_[indexOf(*edge)];
    for (auto at = nodes.rbegin(); at != nodes.rend() && !hold.host; ++at) {
      const bool isAbove = *edge == lowest && share(*edge, *at) > from;
      if (!isAbove && isThere(*at) && !leftOut(*at) && !result_.isAncestor(attached, *at))
        hold.host = *at;
    }
    if (hold.host && *edge == lowest) {
      hold.place = result_[*hold.host].position;
      const double above = share(*edge, *hold.host) * edgeLength(reference_, *edge);
      hold.edge = above > found_.tolerance ? EdgeType::successor // amid the edge that goes on
                                           : reference_[*edge].edge;
    } else if (*edge == lowest) {
      hold.edge = reference_[*edge].edge;
    }
    if (hold.host) break; // else it leaves this edge at its upper end
    if (*edge != lowest && found_.ofReference[indexOf(*edge)] == Difference::missed)
      hold.path.push_back(*edge);
    if (const auto parent = reference_[*edge].parent) hold.place = reference_[*parent].position;
  }
  std::ranges::reverse(hold.path);
  return hold;
}

} // namespace espalier
