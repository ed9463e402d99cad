#include "core/skeleton/review_walk.h"
#include "tests/support/plants.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;

std::vector<std::vector<unsigned>> numbers(const std::vector<Stretch>& stretches) {
  std::vector<std::vector<unsigned>> result;
  for (const Stretch& stretch : stretches) {
    result.emplace_back();
    for (const NodeId id : stretch)
      result.back().push_back(static_cast<unsigned>(id));
  }
  return result;
}

TEST(ReviewWalk, GoesUpTheTrunkAndThenBranchByBranchWithItsTwigs) {
  EXPECT_THAT(
      numbers(axesInWalkOrder(test::walkedTree())),
      ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(4, 5), ElementsAre(6), ElementsAre(7)));
}

TEST(ReviewWalk, StretchesEndAtBranchings) {
  EXPECT_THAT(numbers(stretches(test::walkedTree(), 100)),
              ElementsAre(ElementsAre(0, 1), ElementsAre(2), ElementsAre(3), ElementsAre(4),
                          ElementsAre(5), ElementsAre(6), ElementsAre(7)));
}

TEST(ReviewWalk, StretchesAreNoLongerThanAsked) {
  const Skeleton plant = test::stick(8); // seven edges of 1
  EXPECT_THAT(numbers(stretches(plant, 3)),
              ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(4, 5, 6), ElementsAre(7)));
  EXPECT_EQ(stretches(plant, 0.5).size(), 7U) << "one for each edge: all are longer than that";
  EXPECT_DOUBLE_EQ(longestStretch(plant), 0.7);
}

// The plant is 3 high and 2 wide: two of its longest stretches are 0.72.
TEST(ReviewWalk, OneLookIsAnAxisOrAsMuchAsTwoStretches) {
  Skeleton plant = test::walkedTree();
  const NodeId a =
      plant.add({.position = {0.3, 0, 3}, .parent = NodeId{3}, .edge = EdgeType::branching});
  const NodeId b =
      plant.add({.position = {0, 0.3, 3}, .parent = NodeId{3}, .edge = EdgeType::branching});
  EXPECT_TRUE(isOneLook(plant, {}));
  EXPECT_TRUE(isOneLook(plant, {NodeId{3}, NodeId{0}, NodeId{2}})) << "along the trunk";
  EXPECT_FALSE(isOneLook(plant, {NodeId{0}, NodeId{4}}));
  EXPECT_FALSE(isOneLook(plant, plant.ids()));
  EXPECT_TRUE(isOneLook(plant, {a, b})) << "two short twigs";
}

TEST(ReviewWalk, LeavesOutNoNodeOfAnyPlant) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Skeleton plant = test::randomPlant(200, seed);
    std::vector<NodeId> walked;
    for (const Stretch& stretch : stretches(plant, 5))
      walked.insert(walked.end(), stretch.begin(), stretch.end());
    std::vector<NodeId> all = plant.ids();
    std::ranges::sort(walked);
    std::ranges::sort(all);
    ASSERT_EQ(walked, all) << "seed " << seed;
  }
}

TEST(ReviewWalk, OfNothingGoesNowhere) {
  const Skeleton nothing;
  EXPECT_TRUE(stretches(nothing, 1).empty());
  EXPECT_EQ(longestStretch(nothing), 0);
}

} // namespace
} // namespace espalier
