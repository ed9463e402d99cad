#include "core/reconstruct/join_gaps.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const GapOptions options{.widest = 1.5, .reach = 8};

/// Nodes 1 apart from `from`, in `way`, on `parent`.
std::vector<NodeId> grow(Skeleton& plant, std::optional<NodeId> parent, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& way, int nodes) {
  std::vector<NodeId> ids;
  for (int i = 0; i < nodes; ++i) {
    parent = plant.add({.position = from + i * way, .radius = 0.1, .parent = parent});
    ids.push_back(*parent);
  }
  return ids;
}

// Two upright axes 3 apart; the upper part of the first, beyond a gap of 4, was hung on the second,
// which is nearer.
TEST(WithJoinedGaps, HangsWhatGoesOnStraightOnTheWoodBelowIt) {
  Skeleton plant;
  const auto first = grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 6);
  const auto second = grow(plant, first[0], {1, 0, 0}, {0, 0, 1}, 1);
  const auto beside = grow(plant, second[0], {2, 0, 0}, {0.1, 0, 1}, 16);
  const auto upper = grow(plant, beside[8], {0, 0, 9}, {0, 0, 1}, 6);
  ASSERT_LT((plant[upper[0]].position - plant[beside[8]].position).norm(), 4);
  const Skeleton joined = withJoinedGaps(plant, options);
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
  const Skeleton joined = withJoinedGaps(plant, options);
  EXPECT_EQ(joined[upper.back()].parent, first.back());
  for (std::size_t i = 0; i + 1 < upper.size(); ++i)
    EXPECT_EQ(joined[upper[i]].parent, upper[i + 1]);
}

TEST(WithJoinedGaps, LeavesAPlantWithoutGaps) {
  for (const Skeleton& plant : {test::stick(20), test::fork(4), Skeleton(), test::stick(1)})
    EXPECT_EQ(withJoinedGaps(plant, options), plant);
}

TEST(WithJoinedGaps, LeavesOnItsEdgeWhatNothingElseIsInReachOf) {
  Skeleton plant;
  const auto first = grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 4);
  const auto far = grow(plant, first[1], {50, 0, 0}, {0, 0, 1}, 4);
  EXPECT_EQ(withJoinedGaps(plant, options), plant);
  EXPECT_EQ(plant[far[0]].parent, first[1]);
}

TEST(WithJoinedGaps, KeepsTreesApart) {
  Skeleton plant;
  grow(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 4);
  grow(plant, std::nullopt, {0, 0, 6}, {0, 0, 1}, 4);
  EXPECT_EQ(withJoinedGaps(plant, options), plant);
}

TEST(WithJoinedGaps, MakesATreeOfAnyMessOfFragments) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Skeleton plant = test::randomPlant(120, seed);
    const Skeleton joined = withJoinedGaps(plant, {.widest = 1, .reach = 1000});
    EXPECT_EQ(joined.size(), plant.size());
    EXPECT_EQ(joined.ids().size(), plant.size()) << "each node hangs on a root";
    EXPECT_EQ(joined.roots(), plant.roots());
  }
}

TEST(WithJoinedGaps, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked(
      [](const Progress& progress) { (void)withJoinedGaps(test::stick(5), options, progress); }));
}

} // namespace
} // namespace espalier
