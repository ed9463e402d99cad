#include "core/evaluate/traits/internodes.h"
#include "tests/support/plants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double goldenAngle = 137.5 * degree;

/// A trunk of nodes 0.5 apart along z, and on each but the first a branch, level, each turned by
/// the golden angle from the one before.
Skeleton spiral(int branches) {
  Skeleton plant = test::stick(branches + 1, 0.5);
  for (int i = 1; i <= branches; ++i) {
    const NodeId bearer{static_cast<std::uint32_t>(i)};
    const double angle = i * goldenAngle;
    plant.add({.position = plant[bearer].position +
                           Eigen::Vector3d(2 * std::cos(angle), 2 * std::sin(angle), 0),
               .parent = bearer,
               .edge = EdgeType::branching});
  }
  return plant;
}

TEST(Internodes, MeasureLengthInclinationAndTurn) {
  Skeleton plant = test::stick(2, 2);
  const NodeId level = plant.add({.position = {3, 0, 2}, .parent = NodeId{1}});
  const NodeId down = plant.add({.position = {3, 0, 1}, .parent = level});
  const std::vector<Internode> result = internodes(plant);
  EXPECT_EQ(result[0].length, 0);
  EXPECT_FALSE(result[0].inclination);
  EXPECT_DOUBLE_EQ(result[1].length, 2);
  EXPECT_NEAR(result[1].inclination.value(), 0, 1e-12);
  EXPECT_FALSE(result[1].turn) << "its parent is a root";
  EXPECT_DOUBLE_EQ(result[indexOf(level)].length, 3);
  EXPECT_NEAR(result[indexOf(level)].inclination.value(), 90 * degree, 1e-12);
  EXPECT_NEAR(result[indexOf(level)].turn.value(), 90 * degree, 1e-12);
  EXPECT_NEAR(result[indexOf(down)].inclination.value(), 180 * degree, 1e-12);
}

TEST(Internodes, FindTheSpiralOfBranchesOnATrunk) {
  const std::vector<Internode> result = internodes(spiral(12));
  for (std::size_t i = 1; i <= 12; ++i) {
    const Internode& branch = result[12 + i];
    EXPECT_NEAR(branch.azimuth.value(),
                std::fmod(static_cast<double>(i) * goldenAngle, 360 * degree), 1e-9);
    if (i == 1) {
      EXPECT_FALSE(branch.divergence);
      EXPECT_FALSE(branch.spacing);
    } else {
      EXPECT_NEAR(branch.divergence.value(), goldenAngle, 1e-9);
      EXPECT_NEAR(branch.spacing.value(), 0.5, 1e-12);
    }
  }
}

TEST(Internodes, FindTheSameSpiralOnATrunkThatLies) {
  const Eigen::AngleAxisd turn(1.2, Eigen::Vector3d(1, 2, -0.5).normalized());
  Skeleton plant = spiral(12);
  for (const NodeId id : plant.ids())
    plant.setPosition(id, turn * plant[id].position);
  const std::vector<Internode> result = internodes(plant);
  for (std::size_t i = 2; i <= 12; ++i)
    EXPECT_NEAR(result[12 + i].divergence.value(), goldenAngle, 1e-9);
}

// A trunk that bends from z to x within the plane of x and z. Its branches go along y, which that
// bend does not move: so none turns from the one before.
TEST(Internodes, CarryTheReferenceAlongABend) {
  Skeleton plant;
  std::optional<NodeId> at;
  std::vector<NodeId> branches;
  for (int i = 0; i <= 10; ++i) {
    const double angle = i * 9 * degree;
    at = plant.add({.position = {1 - std::cos(angle), 0, std::sin(angle)}, .parent = at});
    branches.push_back(plant.add({.position = plant[*at].position + Eigen::Vector3d::UnitY(),
                                  .parent = at,
                                  .edge = EdgeType::branching}));
  }
  const std::vector<Internode> result = internodes(plant);
  for (std::size_t i = 1; i < branches.size(); ++i) {
    const double divergence = result[indexOf(branches[i])].divergence.value();
    EXPECT_NEAR(std::sin(divergence), 0, 1e-9);
    EXPECT_NEAR(std::cos(divergence), 1, 1e-9);
  }
}

TEST(Internodes, HaveNoAnglesWhereNodesCoincideOrABranchFollowsItsAxis) {
  Skeleton plant = test::stick(2);
  const NodeId same = plant.add({.position = {0, 0, 1}, .parent = NodeId{1}});
  const NodeId along =
      plant.add({.position = {0, 0, 3}, .parent = NodeId{1}, .edge = EdgeType::branching});
  const std::vector<Internode> result = internodes(plant);
  EXPECT_FALSE(result[indexOf(same)].inclination);
  EXPECT_FALSE(result[indexOf(same)].turn);
  EXPECT_FALSE(result[indexOf(along)].azimuth);
  EXPECT_TRUE(internodes(Skeleton{}).empty());
}

} // namespace
} // namespace espalier
