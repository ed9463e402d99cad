#include "core/graph/geodesic_balls.h"

namespace espalier {

// Breadth first from each point that is in no group yet: along the plant, where points that are
// near in the order of the cloud may lie on two twigs.
BallGroups ballGroups(const NeighborhoodGraph& graph) {
  constexpr auto most = static_cast<std::size_t>(GeodesicBalls::most);
  const auto count = static_cast<std::size_t>(graph.size());
  BallGroups groups;
  groups.points.reserve(count);
  std::vector<bool> isGrouped(count, false);
  for (std::size_t seed = 0; seed < count; ++seed) {
    if (isGrouped[seed]) continue;
    const std::size_t first = groups.points.size();
    const auto add = [&](std::size_t point) {
      if (isGrouped[point] || groups.points.size() - first == most) return;
      isGrouped[point] = true;
      groups.points.push_back(static_cast<std::uint32_t>(point));
    };
    add(seed);
    for (std::size_t next = first; next < groups.points.size(); ++next)
      for (const NeighborhoodGraph::Link& link : graph.links(groups.points[next]))
        add(link.to);
    groups.ends.push_back(groups.points.size());
  }
  return groups;
}

} // namespace espalier
