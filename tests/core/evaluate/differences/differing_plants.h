#pragma once

#include "core/skeleton/edits.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier::test {

/// A trunk from the origin to 10 high, nodes 1 apart, and a branch from 5 high along x, 4 long.
struct TrunkAndBranch {
  Skeleton plant;
  std::vector<NodeId> trunk;  // by height
  std::vector<NodeId> branch; // from its first node on
};

[[nodiscard]] inline TrunkAndBranch trunkAndBranch() {
  TrunkAndBranch made;
  for (int z = 0; z <= 10; ++z)
    made.trunk.push_back(
        made.plant.add({.position = {0, 0, double(z)},
                        .radius = 0.3,
                        .parent = z > 0 ? std::optional(made.trunk.back()) : std::nullopt}));
  for (int x = 1; x <= 4; ++x)
    made.branch.push_back(
        made.plant.add({.position = {double(x), 0, 5},
                        .radius = 0.1,
                        .parent = x > 1 ? made.branch.back() : made.trunk[5],
                        .edge = x > 1 ? EdgeType::successor : EdgeType::branching}));
  return made;
}

/// What an edit makes of a plant.
template <class Edit> [[nodiscard]] Skeleton edited(Skeleton plant, const Edit& edit) {
  SkeletonEditor editor(plant);
  edit(editor);
  (void)editor.commit();
  return plant;
}

/// Two arms from one root that cross within 0.02 above it: along x at 1 high, and along y.
struct CrossingArms {
  Skeleton plant;
  std::vector<NodeId> alongX; // five nodes, the third at the crossing
  std::vector<NodeId> alongY;
};

[[nodiscard]] inline CrossingArms crossingArms() {
  CrossingArms made;
  const NodeId root = made.plant.add({});
  for (const bool isX : {true, false})
    for (int i = -2; i <= 2; ++i) {
      std::vector<NodeId>& arm = isX ? made.alongX : made.alongY;
      const Eigen::Vector3d place = isX ? Eigen::Vector3d(i, 0, 1) : Eigen::Vector3d(0, i, 1.02);
      const EdgeType edge = !isX && i == -2 ? EdgeType::branching : EdgeType::successor;
      arm.push_back(
          made.plant.add({.position = place, .parent = i > -2 ? arm.back() : root, .edge = edge}));
    }
  return made;
}

} // namespace espalier::test
