#include "core/doubt/reference_places.h"

#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

ReferencePlaces::ReferencePlaces(const Skeleton& plant)
    : plant_(plant), index_(plant), depths_(plant.idEnd()) {
  for (const NodeId id : plant.ids())
    if (const auto parent = plant[id].parent)
      depths_[indexOf(id)] = depths_[indexOf(*parent)] + edgeLength(plant, id);
}

ReferencePlace ReferencePlaces::nearest(const Eigen::Vector3d& point) const {
  const auto found = index_.nearest(point);
  return {.node = found->node,
          .depth =
              depths_[indexOf(found->node)] - (1 - found->share) * edgeLength(plant_, found->node),
          .position = found->position,
          .distance = found->distance};
}

ReferencePlace ReferencePlaces::below(const ReferencePlace& from,
                                      const Eigen::Vector3d& point) const {
  ReferencePlace best = from;
  best.distance = (from.position - point).norm();
  Eigen::Vector3d upper = from.position;
  NodeId id = from.node;
  while (const auto parent = plant_[id].parent) {
    const Eigen::Vector3d lower = plant_[*parent].position;
    const Eigen::Vector3d edge = lower - upper;
    const double length = edge.squaredNorm();
    const double share = length > 0 ? std::clamp(edge.dot(point - upper) / length, 0.0, 1.0) : 0;
    const Eigen::Vector3d place = upper + share * edge;
    const double distance = (place - point).norm();
    if (distance < best.distance)
      best = {.node = id,
              .depth = depths_[indexOf(*parent)] + (1 - share) * edge.norm(),
              .position = place,
              .distance = distance};
    upper = lower;
    id = *parent;
  }
  return best;
}

std::vector<double> detours(const std::vector<WoodFrom>& links, const ReferencePlaces& known,
                            double near) {
  std::vector<double> lengths;
  for (const WoodFrom& link : links) {
    const ReferencePlace to = known.nearest(link.to);
    const ReferencePlace from = known.below(to, link.from);
    const double reach = near + 1.5 * known.radiusAt(known.nearest(link.from));
    lengths.push_back(from.distance < reach ? to.depth - from.depth + from.distance
                                            : std::numeric_limits<double>::infinity());
  }
  const double least = *std::ranges::min_element(lengths);
  for (double& length : lengths)
    length = std::isfinite(length) ? length - least : std::numeric_limits<double>::infinity();
  return lengths;
}

} // namespace espalier
