#include "core/doubt/plant_share.h"

#include "core/skeleton/branch_end.h"
#include "core/skeleton/length_along.h"

#include <algorithm>

namespace espalier {

PlantShare::PlantShare(const Skeleton& plant) {
  length_ = lengthOf(plant, plant.ids());
  ends_ = static_cast<double>(tipCount(plant));
}

double PlantShare::of(double length, double ends) const {
  const auto share = [](double part, double all) {
    return part > 0 ? part / std::max(part, all) : 0;
  };
  return (share(length, length_) + share(ends, ends_)) / 2;
}

std::vector<NodeId> runFrom(const Skeleton& skeleton, NodeId id) {
  std::vector<NodeId> run = {id};
  while (skeleton.children(run.back()).size() == 1)
    run.push_back(skeleton.children(run.back()).front());
  return run;
}

double lengthOf(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  double length = 0;
  for (const NodeId id : nodes)
    length += edgeLength(skeleton, id);
  return length;
}

} // namespace espalier
