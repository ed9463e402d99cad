#include "core/skeleton/points_expected.h"

#include "core/skeleton/length_along.h"

#include <algorithm>

namespace espalier {

PointsExpected::PointsExpected(const Skeleton& skeleton, const PointDistances& distances,
                               double reach)
    : perLength_(skeleton.idEnd(), 0) {
  std::vector<double> points(skeleton.idEnd(), 0); // by id
  for (std::size_t i = 0; i < distances.toSurface().size(); ++i)
    if (distances.toSurface()[i] <= reach) points[indexOf(distances.nearest()[i])] += 1;
  std::vector<NodeId> edges = skeleton.ids();
  std::erase_if(edges, [&](NodeId id) { return !skeleton[id].parent; });
  std::ranges::stable_sort(edges, {}, [&](NodeId id) { return skeleton[id].radius; });
  std::vector<double> lengthTo = {0}; // of all edges before
  std::vector<double> pointsTo = {0};
  for (const NodeId id : edges) {
    lengthTo.push_back(lengthTo.back() + edgeLength(skeleton, id));
    pointsTo.push_back(pointsTo.back() + points[indexOf(id)]);
  }
  const double half = lengthTo.back() / 8;
  std::size_t first = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double middle = (lengthTo[i] + lengthTo[i + 1]) / 2;
    while (lengthTo[first + 1] < middle - half)
      ++first;
    while (end < edges.size() && lengthTo[end] < middle + half)
      ++end;
    const double length = lengthTo[end] - lengthTo[first];
    if (length > 0) perLength_[indexOf(edges[i])] = (pointsTo[end] - pointsTo[first]) / length;
  }
}

} // namespace espalier
