#include "core/simulate/grown_radii.h"

#include "core/base/error.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <optional>
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

/// How much wider a trunk is at this height above the ground.
double flareAt(double height, const GrownRadiusOptions& options) {
  return 1 + options.flare * std::exp(-height / (1.5 * options.baseRadius));
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
  struct Axis {
    double vigor = 1;             // by which it is thicker than the pipe model has it
    std::optional<double> ground; // [L], of a trunk
  };
  std::vector<Axis> axes(plant.idEnd()); // by id of node
  for (const NodeId id : order) {
    const Node& node = plant[id];
    Axis& axis = axes[indexOf(id)];
    if (!node.parent)
      axis.ground = node.position.z();
    else if (node.edge == EdgeType::branching)
      axis.vigor = std::exp(options.spread * random.normal());
    else
      axis = axes[indexOf(*node.parent)];
    double radius = axis.vigor * options.apexRadius * std::pow(load[indexOf(id)], exponent);
    if (axis.ground) radius *= flareAt(std::max(0.0, node.position.z() - *axis.ground), options);
    if (node.parent) radius = std::min(radius, plant[*node.parent].radius);
    plant.setRadius(id, radius);
  }
  return plant;
}

} // namespace espalier
