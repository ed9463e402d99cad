#include "core/skeleton/duplicates.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::IsEmpty;

/// A chain of nodes on `parent`, whose first branches. Returns its ids.
std::vector<NodeId> addBranch(Skeleton& plant, NodeId parent, const std::vector<Vector3d>& places) {
  std::vector<NodeId> ids;
  for (const Vector3d& place : places) {
    const NodeId below = ids.empty() ? parent : ids.back();
    ids.push_back(plant.add({.position = place,
                             .parent = below,
                             .edge = ids.empty() ? EdgeType::branching : EdgeType::successor}));
  }
  return ids;
}

TEST(DuplicateTolerance, IsAQuarterOfAnEdge) {
  EXPECT_DOUBLE_EQ(duplicateTolerance(test::stick(5, 2)), 0.5);
  EXPECT_EQ(duplicateTolerance(Skeleton()), 0);
}

TEST(DuplicatedNodes, LieTogetherAndAreNoParentAndChild) {
  Skeleton plant = test::stick(4);
  plant.add({.position = {0.05, 0, 1}, .parent = NodeId{3}});
  plant.add({.position = {0, 0.05, 3}, .parent = NodeId{3}, .edge = EdgeType::branching});
  EXPECT_THAT(duplicatedNodes(plant, 0.1), testing::UnorderedElementsAre(NodeId{1}, NodeId{4}));
  EXPECT_THAT(duplicatedNodes(plant, 0.01), IsEmpty());
}

TEST(DuplicatedNodes, AreFoundInOnePlaceAndFarFromTheOrigin) {
  Skeleton plant;
  const Vector3d far(600'000, 5'000'000, 100);
  for (int i = 0; i < 3; ++i)
    plant.add({.position = far + Vector3d(0, 0, 0.001 * i)});
  EXPECT_EQ(duplicatedNodes(plant, 0.0011).size(), 3U);
  EXPECT_THAT(duplicatedNodes(plant, 0.0009), IsEmpty());
  EXPECT_THAT(duplicatedNodes(Skeleton(), 1), IsEmpty());
}

TEST(DuplicatedBranches, AreTheShorterOfTwoThatRunTogether) {
  Skeleton plant = test::stick(4);
  addBranch(plant, NodeId{1}, {{1, 0, 1}, {2, 0, 1}, {3, 0, 1}});
  const auto twin = addBranch(plant, NodeId{1}, {{0.5, 0.1, 1}, {1.5, 0.1, 1}, {2.5, 0.1, 1}});
  EXPECT_THAT(duplicatedBranches(plant, 0.75), testing::ElementsAreArray(twin));
  EXPECT_THAT(duplicatedBranches(plant, 0.09), IsEmpty());
}

TEST(DuplicatedBranches, AreNoneWhereABranchLeavesTheOther) {
  Skeleton plant = test::stick(4);
  addBranch(plant, NodeId{1}, {{1, 0, 1}, {2, 0, 1}, {3, 0, 1}});
  addBranch(plant, NodeId{1}, {{1, 0.1, 1}, {2, 0.1, 1}, {2.5, 2, 1}});
  EXPECT_THAT(duplicatedBranches(plant, 0.5), IsEmpty());
}

TEST(DuplicatedBranches, LeaveShortTwigsOfTheTrunk) {
  Skeleton plant = test::stick(4);
  addBranch(plant, NodeId{1}, {{0.2, 0, 1}});
  EXPECT_THAT(duplicatedBranches(plant, 0.25), IsEmpty());
  EXPECT_THAT(duplicatedBranches(Skeleton(), 0.25), IsEmpty());
  EXPECT_THAT(duplicatedBranches(plant, 0), IsEmpty());
}

} // namespace
} // namespace espalier
