#include "core/skeleton/points_expected.h"

#include "core/skeleton/length_along.h"

#include <algorithm>

namespace espalier {

PointsExpected::PointsExpected(const Skeleton& skeleton, const PointDistances& distances,
                               double reach)
    : place_(skeleton.idEnd()) {
  std::vector<double> points(skeleton.idEnd(), 0); // by id
  for (std::size_t i = 0; i < distances.toSurface().size(); ++i)
    if (distances.toSurface()[i] <= reach) points[indexOf(distances.nearest()[i])] += 1;
  std::vector<NodeId> nodes = skeleton.ids();
  std::erase_if(nodes, [&](NodeId id) { return !skeleton[id].parent; });
  std::ranges::stable_sort(nodes, {}, [&](NodeId id) { return skeleton[id].radius; });
  for (const NodeId id : nodes) {
    place_[indexOf(id)] = edges_.size();
    edges_.push_back({id, edgeLength(skeleton, id), points[indexOf(id)]});
    length_ += edges_.back().length;
  }
}

double PointsExpected::perLength(const std::vector<NodeId>& edges) const {
  std::vector<bool> isLeftOut(edges_.size(), false);
  double length = length_;
  std::size_t thickest = 0;
  for (const NodeId id : edges) {
    const std::size_t place = place_[indexOf(id)];
    isLeftOut[place] = true;
    length -= edges_[place].length;
    thickest = std::max(thickest, place);
  }
  double seen = 0;   // [L]
  double points = 0; // along that
  const auto look = [&](std::size_t first, std::ptrdiff_t step) {
    double side = 0;
    for (std::size_t i = first; i < edges_.size() && side < length / 8;
         i += static_cast<std::size_t>(step)) { // below 0 wraps, too
      if (isLeftOut[i]) continue;
      side += edges_[i].length;
      points += edges_[i].points;
    }
    seen += side;
  };
  look(thickest - 1, -1);
  look(thickest + 1, 1);
  return seen > 0 ? points / seen : 0;
}

} // namespace espalier
