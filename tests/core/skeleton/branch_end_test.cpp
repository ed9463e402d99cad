#include "core/skeleton/branch_end.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using ::testing::ElementsAre;

TEST(BranchEnds, RunFromABranchingToATip) {
  Skeleton plant = test::stick(5);
  const NodeId first = plant.add({.position = {1, 0, 2}, .parent = NodeId{2}});
  const NodeId tip = plant.add({.position = {1, 3, 2}, .parent = first});

  const auto end = branchEndAt(plant, tip);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->foot, NodeId{2});
  EXPECT_THAT(end->nodes, ElementsAre(tip, first));
  EXPECT_DOUBLE_EQ(end->length, 4);

  const std::vector<BranchEnd> ends = branchEnds(plant);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_THAT(ends[0].nodes, ElementsAre(NodeId{4}, NodeId{3}));
  EXPECT_THAT(ends[1].nodes, ElementsAre(tip, first));
}

TEST(BranchEnds, AreNoneOfAnUnbranchedPlant) {
  EXPECT_FALSE(branchEndAt(test::stick(4), NodeId{3}));
  EXPECT_TRUE(branchEnds(test::stick(4)).empty());
  EXPECT_TRUE(branchEnds({}).empty());
}

} // namespace
} // namespace espalier
