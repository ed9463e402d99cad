#include "core/reconstruct/join_gaps.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const GapOptions gapOptions{.widest = 1.5, .reach = 8};

/// Nodes 1 apart from `from`, by `step`, on `parent`.
std::vector<NodeId> grow(Skeleton& plant, std::optional<NodeId> parent, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& step, int nodes) {
  std::vector<NodeId> ids;
  for (int i = 0; i < nodes; ++i) {
    parent = plant.add({.position = from + i * step, .radius = 0.1, .parent = parent});
    ids.push_back(*parent);
  }
  return ids;
}

// Two upright axes 3 apart; the upper part of the first, beyond a gap of 4, was attached to the
// second, which is nearer.
TEST(WithJoinedGaps, AttachesWhatGoesOnStraightToTheWoodBelowIt) {
  Skeleton plant;
  const auto first = grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 6);
  const auto second = grow(plant, first[0], {1, 0, 0}, {0, 0, 1}, 1);
  const auto beside = grow(plant, second[0], {2, 0, 0}, {0.1, 0, 1}, 16);
  const auto upper = grow(plant, beside[8], {0, 0, 9}, {0, 0, 1}, 6);
  ASSERT_LT((plant[upper[0]].position - plant[beside[8]].position).norm(), 4);
  const Skeleton joined = withJoinedGaps(plant, gapOptions);
  EXPECT_EQ(joined[upper[0]].parent, first.back());
  EXPECT_EQ(joined.size(), plant.size());
  EXPECT_EQ(joined.roots().size(), 1U);
}

// The fragment was entered at its top, which is nearest to other wood.
TEST(WithJoinedGaps, TurnsAFragmentAroundThatGrewFromItsOtherEnd) {
  Skeleton plant;
  const auto first = grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 6);
  const auto bridge = grow(plant, first[0], {1, 0, 0}, {1, 0, 0}, 3);
  const auto beside = grow(plant, bridge.back(), {4, 0, 1}, {0, 0, 1}, 14);
  const auto upper = grow(plant, beside.back(), {1, 0, 13.5}, {-0.18, 0, -1}, 6);
  const Skeleton joined = withJoinedGaps(plant, gapOptions);
  EXPECT_EQ(joined[upper.back()].parent, first.back());
  for (std::size_t i = 0; i + 1 < upper.size(); ++i)
    EXPECT_EQ(joined[upper[i]].parent, upper[i + 1]);
}

/// A crown that was entered at its top, 2 from the end of a shoot that bends down to it; its foot
/// is 4 above the end of an axis.
struct EnteredFromAbove {
  Skeleton plant;
  NodeId below;              // the end of the axis
  NodeId above;              // that of the shoot
  std::vector<NodeId> crown; // from the top down
};

EnteredFromAbove enteredFromAbove() {
  EnteredFromAbove result;
  Skeleton& plant = result.plant;
  const auto first = grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 6);
  const auto out = grow(plant, first[0], {1, 0, 0}, {1, 0, 0}, 6);
  const auto up = grow(plant, out.back(), {6, 0, 1}, {0, 0, 1}, 24);
  const auto back = grow(plant, up.back(), {5, 0, 24}, {-1, 0, 0}, 6);
  const auto down = grow(plant, back.back(), {0, 0, 23}, {0, 0, -1}, 4);
  result.below = first.back();
  result.above = down.back();
  result.crown = grow(plant, down.back(), {0, 0, 18}, {0, 0, -1}, 10);
  for (const std::size_t at : {4, 5, 6}) // branches that point up
    grow(plant, result.crown[at], plant[result.crown[at]].position + Eigen::Vector3d(0, 0.7, 0.7),
         {0, 0.7, 0.7}, 5);
  return result;
}

// Three branches at 45 degrees point back: 2.1 times the cost of one, of 2, is more than the foot
// is farther away.
TEST(WithJoinedGaps, AttachesACrownToItsFootAsItsBranchesPoint) {
  const EnteredFromAbove scene = enteredFromAbove();
  EXPECT_EQ(withJoinedGaps(scene.plant, gapOptions), scene.plant)
      << "the nearer end, if they are free";
  GapOptions costly = gapOptions;
  costly.backCost = 2;
  const Skeleton joined = withJoinedGaps(scene.plant, costly);
  EXPECT_EQ(joined[scene.crown.back()].parent, scene.below);
  EXPECT_EQ(joined[scene.crown.front()].parent, scene.crown[1]);
}

// A branch at the bark of a trunk 3 thick is 5 from the axis; a twig ends right before it.
TEST(WithJoinedGaps, TakesNoThickWoodForAGap) {
  const auto withTrunk = [](double radius) {
    Skeleton plant;
    const auto trunk = grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 10);
    for (const NodeId id : trunk)
      plant.setRadius(id, radius);
    grow(plant, trunk[2], {1, 0, 2.8}, {1, 0, 0}, 3);
    grow(plant, trunk[3], {5, 0, 3}, {1, 0, 0}, 5);
    return plant;
  };
  EXPECT_EQ(withJoinedGaps(withTrunk(3), gapOptions), withTrunk(3));
  EXPECT_NE(withJoinedGaps(withTrunk(0.1), gapOptions), withTrunk(0.1)) << "this is one";
}

TEST(WithJoinedGaps, LeavesAPlantWithoutGaps) {
  for (const Skeleton& plant : {test::stick(20), test::fork(4), Skeleton(), test::stick(1)})
    EXPECT_EQ(withJoinedGaps(plant, gapOptions), plant);
}

TEST(WithJoinedGaps, LeavesOnItsEdgeWhatNothingElseIsInReachOf) {
  Skeleton plant;
  const auto first = grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 4);
  const auto far = grow(plant, first[1], {50, 0, 0}, {0, 0, 1}, 4);
  EXPECT_EQ(withJoinedGaps(plant, gapOptions), plant);
  EXPECT_EQ(plant[far[0]].parent, first[1]);
}

TEST(WithJoinedGaps, KeepsTreesApart) {
  Skeleton plant;
  grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 4);
  grow(plant, std::nullopt, {0, 0, 6}, {0, 0, 1}, 4);
  EXPECT_EQ(withJoinedGaps(plant, gapOptions), plant);
}

TEST(WithJoinedGaps, MakesATreeOfAnyMessOfFragments) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Skeleton plant = test::randomPlant(120, seed);
    const Skeleton joined = withJoinedGaps(plant, {.widest = 1, .reach = 1000});
    EXPECT_EQ(joined.size(), plant.size());
    EXPECT_EQ(joined.ids().size(), plant.size()) << "each node is carried by a root";
    EXPECT_EQ(joined.roots(), plant.roots());
  }
}

TEST(WithJoinedGaps, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)withJoinedGaps(test::stick(5), gapOptions, progress);
  }));
}

} // namespace
} // namespace espalier
