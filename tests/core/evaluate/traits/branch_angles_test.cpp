#include "core/evaluate/registration/registration.h"
#include "core/evaluate/traits/branch_angles.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double pi = std::numbers::pi;

/// A straight trunk with a branch at each node but the first, `step` further around each time and
/// at `angle` to the trunk.
Skeleton spiral(int branches, double step, double angle) {
  Skeleton plant = test::stick(branches + 2);
  for (int k = 0; k < branches; ++k) {
    const NodeId foot{static_cast<std::uint32_t>(k + 1)};
    const Eigen::Vector3d direction(std::sin(angle) * std::cos(k * step),
                                    std::sin(angle) * std::sin(k * step), std::cos(angle));
    plant.add({.position = plant[foot].position + 2 * direction,
               .parent = foot,
               .edge = EdgeType::branching});
  }
  return plant;
}

TEST(BranchAngles, OfASpiralAreThoseItIsMadeOf) {
  constexpr double golden = 137.5 * pi / 180;
  for (const double step : {golden, -golden}) { // whichever way around
    const BranchAngles angles = branchAngles(spiral(8, step, 0.9));
    ASSERT_EQ(angles.byOrder.size(), 1U);
    EXPECT_EQ(angles.byOrder[0].count, 8U);
    EXPECT_NEAR(angles.byOrder[0].mean, 0.9, 1e-9);
    EXPECT_NEAR(angles.byOrder[0].deviation, 0, 1e-9);
    EXPECT_EQ(angles.divergence.count, 7U);
    EXPECT_NEAR(angles.divergence.mean, golden, 1e-9);
    EXPECT_EQ(angles.divergences[4], 7U) << "from 120 to 150 degrees";
  }
}

TEST(BranchAngles, OfOppositeBranchesAreHalfATurn) {
  const BranchAngles angles = branchAngles(spiral(5, pi, 0.5));
  EXPECT_NEAR(angles.divergence.mean, pi, 1e-9);
  EXPECT_EQ(angles.divergences[5], 4U);
}

TEST(BranchAngles, CountByTheOrderOfTheBranch) {
  Skeleton plant = spiral(2, 1, 0.9);
  const NodeId tip{4}; // the first branch
  const NodeId next =
      plant.add({.position = plant[tip].position + Eigen::Vector3d(0, 0, 1), .parent = tip});
  plant.add({.position = plant[next].position + Eigen::Vector3d(1, 0, 0),
             .parent = next,
             .edge = EdgeType::branching});
  const BranchAngles angles = branchAngles(plant);
  ASSERT_EQ(angles.byOrder.size(), 2U);
  EXPECT_EQ(angles.byOrder[1].count, 1U);
  EXPECT_NEAR(angles.byOrder[1].mean, pi / 2, 1e-9);
}

TEST(BranchAngles, DependNeitherOnNodesWithinEdgesNorOnTheFrame) {
  const BranchAngles angles = branchAngles(spiral(6, 2, 0.7));
  const BranchAngles other =
      branchAngles(moved(test::withMiddleNodes(spiral(6, 2, 0.7)), test::motion(0.6, {5, -3, 2})));
  EXPECT_NEAR(other.byOrder[0].mean, angles.byOrder[0].mean, 1e-9);
  EXPECT_NEAR(other.divergence.mean, angles.divergence.mean, 1e-9);
}

TEST(BranchAngles, OfATrunkAloneAreNone) {
  EXPECT_TRUE(branchAngles(test::stick(4)).byOrder.empty());
  EXPECT_EQ(branchAngles({}).divergence.count, 0U);
}

} // namespace
} // namespace espalier
