#include "core/evaluate/traits/wood_amounts.h"

#include "core/skeleton/axes.h"
#include "core/skeleton/frustum.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace espalier {
namespace {

void add(WoodAmount& to, const WoodAmount& more) {
  to.edges += more.edges;
  to.length += more.length;
  to.area += more.area;
  to.volume += more.volume;
}

/// The class of the vertex that a node belongs to, by scale.
using ClassesOfNode = std::map<int, std::string>;

/// Of the nodes, by id: the vertices that start at each, and others of its parent.
std::vector<ClassesOfNode> classesOf(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<ClassesOfNode> classes(skeleton.idEnd());
  for (const NodeId id : ids) { // parents before their children
    const Node& node = skeleton[id];
    ClassesOfNode& own = classes[indexOf(id)];
    if (node.parent) own = classes[indexOf(*node.parent)];
    for (const Entity& entity : node.entities)
      own[entity.scale] = entity.symbol;
  }
  return classes;
}

double volumeOf(const Skeleton& skeleton, NodeId id) {
  const auto body = frustumOf(skeleton, id);
  return body ? body->volume() : 0;
}

/// The plant with radii at a bound of their intervals; by hand and unknown, as they are.
double volumeAt(Skeleton plant, float RadiusOrigin::*bound) {
  double sum = 0;
  for (const NodeId id : plant.ids()) { // parents first: they are at their bound already
    const Node& node = plant[id];
    if (node.origin.hasInterval()) plant.setRadius(id, node.origin.*bound * node.radius);
    sum += volumeOf(plant, id);
  }
  return sum;
}

} // namespace

std::optional<VolumeInterval> volumeInterval(const Skeleton& skeleton) {
  constexpr double together = 0.8; // of the logarithms
  double volume = 0;
  bool hasInterval = false;
  for (const NodeId id : skeleton.ids()) {
    volume += volumeOf(skeleton, id);
    hasInterval = hasInterval || skeleton[id].origin.hasInterval();
  }
  if (!hasInterval || !(volume > 0) || volumeOfUnknownError(skeleton) > mostUnknownError)
    return std::nullopt;
  const auto bound = [&](float RadiusOrigin::*which) {
    return volume * std::pow(volumeAt(skeleton, which) / volume, together);
  };
  return VolumeInterval{bound(&RadiusOrigin::least), bound(&RadiusOrigin::most)};
}

double volumeOfUnknownError(const Skeleton& skeleton) {
  double volume = 0;
  double unknown = 0;
  for (const NodeId id : skeleton.ids()) {
    const RadiusOrigin& origin = skeleton[id].origin;
    const double own = volumeOf(skeleton, id);
    volume += own;
    if (!origin.hasInterval() && origin.source != RadiusSource::byHand) unknown += own;
  }
  return volume > 0 ? unknown / volume : 0;
}

std::vector<double> radiusLimits(const Skeleton& skeleton) {
  double most = 0;
  for (const NodeId id : skeleton.ids())
    most = std::max(most, skeleton[id].radius);
  if (most == 0) return {};
  std::vector<double> limits;
  for (const double share : {32.0, 16.0, 8.0, 4.0, 2.0})
    limits.push_back(most / share);
  return limits;
}

WoodAmounts woodAmounts(const Skeleton& skeleton, const std::vector<double>& radiusLimits) {
  WoodAmounts amounts;
  amounts.byRadius.resize(radiusLimits.size() + 1);
  const std::vector<int> orderOf = orders(skeleton);
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<ClassesOfNode> classes = classesOf(skeleton, ids);
  std::map<std::pair<int, std::string>, WoodAmount> byClass;
  for (const NodeId id : ids) {
    if (!skeleton[id].parent) continue;
    const Frustum body = *frustumOf(skeleton, id);
    const WoodAmount edge{
        .edges = 1, .length = body.length(), .area = body.lateralArea(), .volume = body.volume()};
    const auto order = static_cast<std::size_t>(orderOf[indexOf(id)]);
    if (order >= amounts.byOrder.size()) amounts.byOrder.resize(order + 1);
    const auto limit =
        std::ranges::lower_bound(radiusLimits, (body.fromRadius + body.toRadius) / 2);
    add(amounts.whole, edge);
    for (const auto& scaleAndSymbol : classes[indexOf(id)])
      add(byClass[scaleAndSymbol], edge);
    add(amounts.byOrder[order], edge);
    add(amounts.byRadius[static_cast<std::size_t>(limit - radiusLimits.begin())], edge);
  }
  for (const auto& [scaleAndSymbol, wood] : byClass)
    amounts.byClass.push_back({scaleAndSymbol.first, scaleAndSymbol.second, wood});
  return amounts;
}

} // namespace espalier
