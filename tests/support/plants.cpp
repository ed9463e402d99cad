#include "tests/support/plants.h"

#include "core/base/random.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace espalier::test {

Skeleton stick(int nodes, double step) {
  Skeleton plant;
  std::optional<NodeId> parent;
  for (int i = 0; i < nodes; ++i)
    parent = plant.add({.position = {0, 0, i * step}, .radius = 0.1, .parent = parent});
  return plant;
}

Skeleton fork(int shoots) {
  Skeleton plant = stick(2);
  for (int i = 0; i < shoots; ++i) {
    const double angle = 2 * std::numbers::pi * i / shoots;
    plant.add({.position = {std::cos(angle), std::sin(angle), 2},
               .radius = 0.1,
               .parent = forkTop,
               .edge = i == 0 ? EdgeType::successor : EdgeType::branching});
  }
  return plant;
}

std::ptrdiff_t countTips(const Skeleton& skeleton) {
  return std::ranges::count_if(skeleton.ids(),
                               [&](NodeId id) { return skeleton.children(id).empty(); });
}

Skeleton randomPlant(int nodes, std::uint64_t seed) {
  Random random(seed);
  Skeleton plant;
  std::vector<NodeId> ids;
  for (int i = 0; i < nodes; ++i) {
    Node node{.position = random.uniform(0.5, 20) * random.direction(),
              .radius = random.uniform(0.001, 0.3)};
    if (i % std::max(1, nodes / 2) != 0) {
      node.parent = ids[random.below(ids.size())];
      node.edge = random.uniform() < 0.7 ? EdgeType::successor : EdgeType::branching;
    }
    ids.push_back(plant.add(node));
  }
  return plant;
}

Skeleton walkedTree() {
  Skeleton plant = stick(4);
  const auto add = [&](double x, double z, unsigned parent, EdgeType edge) {
    plant.add({.position = {x, 0, z}, .parent = NodeId{parent}, .edge = edge});
  };
  add(1, 1, 1, EdgeType::branching);
  add(2, 1, 4, EdgeType::successor);
  add(1, 2, 4, EdgeType::branching);
  add(1, 3, 2, EdgeType::branching);
  return plant;
}

} // namespace espalier::test
