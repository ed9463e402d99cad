#include "core/skeleton/axes.h"
#include "core/skeleton/slide_insertions.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr InsertionOptions allTheWay{.nodeWeight = 0};

/// An upright stick of 10 nodes 1 apart, and a branch of 4 nodes at 45 degrees that leaves it at
/// `height` and begins 1 to the side; it is attached to node `parent`.
Skeleton withBranch(double height, std::uint32_t parent) {
  Skeleton plant = test::stick(10);
  NodeId below{parent};
  for (int i = 1; i <= 4; ++i)
    below = plant.add({.position = {static_cast<double>(i), 0, height + i},
                       .radius = 0.02,
                       .parent = below,
                       .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
  return plant;
}

constexpr NodeId branch{10};

TEST(WithSlidInsertions, AttachesABranchToTheNodeItComesFrom) {
  const Skeleton plant = withSlidInsertions(withBranch(4, 5), allTheWay);
  EXPECT_EQ(plant[branch].parent, NodeId{4});
  EXPECT_EQ(plant[branch].edge, EdgeType::branching);
  EXPECT_EQ(plant.size(), 14U);
  EXPECT_EQ(withSlidInsertions(withBranch(4, 3), allTheWay)[branch].parent, NodeId{4})
      << "from below, too";
}

TEST(WithSlidInsertions, MakesANodeBetweenTwoForIt) {
  const Skeleton plant = withSlidInsertions(withBranch(4.5, 5), allTheWay);
  ASSERT_EQ(plant.size(), 15U);
  const Node& added = plant[*plant[branch].parent];
  EXPECT_LT((added.position - Eigen::Vector3d(0, 0, 4.5)).norm(), 1e-9);
  EXPECT_NEAR(added.radius, 0.1, 1e-12);
  EXPECT_EQ(added.parent, NodeId{4});
  EXPECT_EQ(plant[NodeId{5}].parent, *plant[branch].parent);
  EXPECT_EQ(axes(plant).size(), 2U);
}

// The line meets the stick at 45 degrees, at 4.2: it has half the weight of one at right angles.
TEST(WithSlidInsertions, GoesPartOfTheDistanceByTheWeightOfTheNode) {
  const auto heightWith = [](double weight) {
    const Skeleton plant =
        withSlidInsertions(withBranch(4.2, 6), {.nearNode = 0, .nodeWeight = weight});
    return plant[*plant[branch].parent].position.z();
  };
  EXPECT_NEAR(heightWith(0), 4.2, 1e-9);
  EXPECT_NEAR(heightWith(0.5), (4.2 + 6) / 2, 1e-9);
  EXPECT_NEAR(heightWith(1), (4.2 + 2 * 6) / 3, 1e-9);
  EXPECT_NEAR(heightWith(100), 6, 0.01);
}

TEST(WithSlidInsertions, DoesNotMoveANode) {
  const Skeleton before = withBranch(4.5, 5);
  const Skeleton after = withSlidInsertions(before, allTheWay);
  for (const NodeId id : before.ids())
    EXPECT_EQ(after[id].position, before[id].position);
}

TEST(WithSlidInsertions, LeavesABranchWhoseLineLeadsPastTheAxis) {
  Skeleton plant = withBranch(4, 5);
  for (const NodeId id : plant.ids()) // the branch runs beside the stick, not from it
    if (indexOf(id) >= 10) plant.setPosition(id, {1, static_cast<double>(indexOf(id)) - 5, 5});
  EXPECT_EQ(withSlidInsertions(plant, allTheWay), plant);
}

TEST(WithSlidInsertions, LooksNoFartherThanItsReach) {
  const Skeleton plant = withSlidInsertions(withBranch(4, 8), {.reach = 2, .nodeWeight = 0});
  EXPECT_NE(plant[branch].parent, NodeId{4});
}

/// withBranch(4.4, 5) and a second branch, from 4.6, on the other side.
Skeleton withTwoBranches() {
  Skeleton plant = withBranch(4.4, 5);
  NodeId below{5};
  for (int i = 1; i <= 4; ++i)
    below = plant.add({.position = {static_cast<double>(-i), 0, 4.6 + i},
                       .radius = 0.02,
                       .parent = below,
                       .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
  return plant;
}

TEST(WithSlidInsertions, GathersBranchesOfOneWhorl) {
  constexpr NodeId second{14};
  const Skeleton apart = withSlidInsertions(withTwoBranches(), {.nodeWeight = 0, .gather = 0.1});
  EXPECT_NEAR(apart[*apart[branch].parent].position.z(), 4.4, 1e-9);
  EXPECT_NEAR(apart[*apart[second].parent].position.z(), 4.6, 1e-9);
  EXPECT_EQ(apart[*apart[second].parent].parent, *apart[branch].parent) << "above the other";
  const Skeleton whorl = withSlidInsertions(withTwoBranches(), {.nodeWeight = 0, .gather = 0.3});
  EXPECT_EQ(whorl[branch].parent, whorl[second].parent);
  EXPECT_NEAR(whorl[*whorl[branch].parent].position.z(), 4.5, 1e-9)
      << "between, as both weigh alike";
  EXPECT_EQ(axes(whorl).size(), 3U);
}

TEST(WithSlidInsertions, LeavesWhatIsAttachedToTheEndOfAnAxis) {
  const Skeleton plant = withBranch(7, 9);
  EXPECT_EQ(withSlidInsertions(plant, allTheWay), plant);
}

TEST(WithSlidInsertions, CopesWithPlantsWithoutAxes) {
  EXPECT_TRUE(withSlidInsertions({}, allTheWay).isEmpty());
  EXPECT_EQ(withSlidInsertions(test::stick(1), allTheWay), test::stick(1));
  EXPECT_EQ(withSlidInsertions(test::stick(3, 0), allTheWay), test::stick(3, 0));
  const Skeleton fork = test::fork(3);
  EXPECT_EQ(withSlidInsertions(fork, allTheWay).size(), fork.size());
}

} // namespace
} // namespace espalier
