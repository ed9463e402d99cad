#include "core/radius/node_count_pipe_model.h"

#include <algorithm>
#include <cmath>

namespace espalier {

std::vector<double> carriedNodes(const Skeleton& skeleton) {
  std::vector<double> carried(skeleton.idEnd(), 1);
  const std::vector<NodeId> ids = skeleton.ids();
  for (auto id = ids.rbegin(); id != ids.rend(); ++id)
    if (skeleton[*id].parent) carried[indexOf(*skeleton[*id].parent)] += carried[indexOf(*id)];
  return carried;
}

Skeleton withNodeCountPipeRadii(const Skeleton& skeleton, const NodeCountPipeOptions& options) {
  Skeleton result = skeleton;
  const std::vector<double> carried = carriedNodes(skeleton);
  const double heaviest = carried.empty() ? 1 : *std::max_element(carried.begin(), carried.end());
  const bool isKnown = options.apexRadius > 0;
  const double exponent =
      isKnown && heaviest > 1
          ? std::log(options.rootRadius / options.apexRadius) / std::log(heaviest)
          : 0;
  for (const NodeId id : skeleton.ids())
    result.setRadius(id,
                     isKnown ? options.apexRadius * std::pow(carried[indexOf(id)], exponent) : 0,
                     {.source = RadiusSource::extrapolated});
  return result;
}

} // namespace espalier
