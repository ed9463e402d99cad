#include "core/simulate/grown_radii.h"

#include "core/base/error.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

// Length of wood that weighs as much as an apex, in apex radii: the node spacing (45 mm) over the
// radius of an apex (2.4 mm) in the expert's Scots pines.
constexpr double lengthPerApex = 19;

/// What each node carries, by id.
std::vector<double> loads(const Skeleton& plant, const std::vector<NodeId>& order, double unit) {
  std::vector<double> load(plant.idEnd(), 0);
  for (std::size_t i = order.size(); i-- > 0;) { // children first
    const NodeId id = order[i];
    double& own = load[indexOf(id)];
    if (plant.children(id).empty()) own = 1;
    const Node& node = plant[id];
    if (!node.parent) continue;
    const double length = (node.position - plant[*node.parent].position).norm();
    load[indexOf(*node.parent)] += own + length / unit;
  }
  return load;
}

/// Height above the ground in trunk radii, turned into a widening.
double flareAt(double height, double radius, double flare) {
  return 1 + flare * std::exp(-height / (1.5 * radius));
}

} // namespace

Skeleton withGrownRadii(Skeleton plant, const GrownRadiusOptions& options) {
  if (!(options.apexRadius > 0) || !(options.baseRadius >= options.apexRadius) ||
      !std::isfinite(options.baseRadius))
    throw Error("base and apex radius: expected base >= apex > 0; try 1/100 and 1/1500 of the "
                "height of the plant");
  if (plant.isEmpty()) return plant;
  const std::vector<NodeId> order = plant.ids();
  const std::vector<double> load = loads(plant, order, lengthPerApex * options.apexRadius);
  const double heaviest = *std::max_element(load.begin(), load.end());
  const double exponent =
      heaviest > 1 ? std::log(options.baseRadius / options.apexRadius) / std::log(heaviest) : 0;

  Random random(options.seed);
  std::vector<double> vigor(plant.idEnd(), 1); // by id, of the axis
  std::vector<double> ground(plant.idEnd(), 0);
  for (const NodeId id : order) {
    const Node& node = plant[id];
    double& own = vigor[indexOf(id)];
    if (!node.parent || node.edge == EdgeType::branching)
      own = node.parent ? std::exp(options.spread * random.normal()) : 1;
    else
      own = vigor[indexOf(*node.parent)];
    ground[indexOf(id)] = node.parent ? ground[indexOf(*node.parent)] : node.position.z();
    double radius = own * options.apexRadius * std::pow(load[indexOf(id)], exponent);
    radius *= flareAt(std::max(0.0, node.position.z() - ground[indexOf(id)]), options.baseRadius,
                      options.flare);
    if (node.parent) radius = std::min(radius, plant[*node.parent].radius);
    plant.setRadius(id, radius);
  }
  return plant;
}

} // namespace espalier
