#pragma once

#include "core/base/random.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Geometry>

namespace espalier::test {

/// `plant` with each position p at place(p), and radii unchanged.
template <class Place> [[nodiscard]] Skeleton placed(Skeleton plant, const Place& place) {
  for (const NodeId id : plant.ids())
    plant.setPosition(id, place(plant[id].position));
  return plant;
}

[[nodiscard]] inline Skeleton shifted(const Skeleton& plant, const Eigen::Vector3d& by) {
  return placed(plant, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p + by; });
}

[[nodiscard]] inline Skeleton scaled(const Skeleton& plant, double factor) {
  return placed(plant, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p * factor; });
}

[[nodiscard]] inline Skeleton jittered(const Skeleton& plant, double sigma) {
  Random random(99);
  return placed(plant, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return p + sigma * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  });
}

/// A turn by `angle` about an oblique axis through the origin, then a shift.
[[nodiscard]] inline Eigen::Isometry3d motion(double angle, const Eigen::Vector3d& shift) {
  Eigen::Isometry3d result(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 3).normalized()));
  result.pretranslate(shift);
  return result;
}

/// `plant` with a node in the middle of each edge.
[[nodiscard]] inline Skeleton withMiddleNodes(Skeleton plant) {
  for (const NodeId id : plant.ids()) {
    const Node node = plant[id];
    if (!node.parent) continue;
    const Eigen::Vector3d middle = (node.position + plant[*node.parent].position) / 2;
    plant.reparent(id, plant.add({.position = middle, .parent = node.parent, .edge = node.edge}),
                   EdgeType::successor);
  }
  return plant;
}

/// A small tree, about 10 high: a trunk with 16 crooked shoots that carry twigs. 433 nodes.
[[nodiscard]] inline Skeleton bush() {
  Random random(5);
  Skeleton plant;
  const auto grow = [&](NodeId from, const Eigen::Vector3d& advance, int nodes) {
    std::vector<NodeId> shoot = {from};
    for (int i = 0; i < nodes; ++i)
      shoot.push_back(plant.add(
          {.position = plant[shoot.back()].position + advance + 0.1 * random.direction(),
           .parent = shoot.back(),
           .edge = i == 0 && from != NodeId{0} ? EdgeType::branching : EdgeType::successor}));
    return shoot;
  };
  const NodeId root = plant.add({});
  const std::vector<NodeId> trunk = grow(root, {0, 0, 0.5}, 16);
  for (std::size_t i = 1; i < trunk.size(); ++i) {
    const std::vector<NodeId> shoot = grow(trunk[i], 0.4 * random.direction(), 8);
    for (std::size_t k = 1; k < shoot.size(); k += 2)
      (void)grow(shoot[k], 0.3 * random.direction(), 4);
  }
  return plant;
}

} // namespace espalier::test
