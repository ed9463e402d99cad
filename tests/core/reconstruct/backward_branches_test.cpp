#include "core/reconstruct/backward_branches.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

const double half = std::sqrt(0.5); // the cosine of 45 degrees

std::vector<bool> noCuts(const Skeleton& plant) {
  return std::vector<bool>(plant.idEnd(), false);
}

/// `count` nodes from `parent` on, each by `step`.
void grow(Skeleton& plant, NodeId parent, const Eigen::Vector3d& step, int count) {
  for (int i = 0; i < count; ++i)
    parent = plant.add({.position = plant[parent].position + step, .parent = parent});
}

/// A stick of 11 nodes, with a branch of 5 nodes at 45 degrees from its middle.
Skeleton branched() {
  Skeleton plant = test::stick(11);
  grow(plant, NodeId{5}, {half, 0, half}, 5);
  return plant;
}

TEST(BackwardBranches, AreNoneFromTheFootAndOneFromTheTop) {
  const Skeleton plant = branched();
  const std::vector<double> sums = backwardBranches(plant, noCuts(plant));
  EXPECT_NEAR(sums[0], 0, 1e-12);
  EXPECT_NEAR(sums[10], half, 1e-12) << "the branch points to it";
  EXPECT_NEAR(sums[15], half, 1e-12) << "from the branch, the upper stick does";
  EXPECT_NEAR(sums[5], 1 + half, 1e-12) << "stick and branch go on through the middle";
}

// The branch now leaves the foot of another part.
TEST(BackwardBranches, EndAtCuts) {
  const Skeleton plant = branched();
  std::vector<bool> isCut = noCuts(plant);
  isCut[6] = true;
  const std::vector<double> sums = backwardBranches(plant, isCut);
  EXPECT_NEAR(sums[0], 0, 1e-12);
  EXPECT_NEAR(sums[6], 0, 1e-12);
  EXPECT_NEAR(sums[10], 0, 1e-12) << "a stick has two ends";
  EXPECT_NEAR(sums[15], 0, 1e-12) << "obtuse";
}

TEST(BackwardBranches, CountLessIfTheyAreShort) {
  Skeleton plant = test::stick(11);
  grow(plant, NodeId{5}, {half, 0, half}, 1);
  EXPECT_NEAR(backwardBranches(plant, noCuts(plant))[10], half / 4, 1e-12);
}

// Whatever node a plant is rooted at, each way to enter it costs the same.
TEST(BackwardBranches, DoNotDependOnWhereTheEdgesLeadNow) {
  Skeleton plant = test::randomPlant(60, 3);
  const std::vector<double> before = backwardBranches(plant, noCuts(plant));
  NodeId top = plant.roots().front();
  while (!plant.children(top).empty())
    top = plant.children(top).front();
  std::vector<NodeId> path = {top};
  while (const auto parent = plant[path.back()].parent)
    path.push_back(*parent);
  for (const NodeId id : path)
    plant.makeRoot(id);
  for (std::size_t i = 1; i < path.size(); ++i)
    plant.reparent(path[i], path[i - 1], EdgeType::successor);
  const std::vector<double> after = backwardBranches(plant, noCuts(plant));
  ASSERT_GT(path.size(), 2U);
  for (const NodeId id : plant.ids())
    EXPECT_NEAR(after[indexOf(id)], before[indexOf(id)], 1e-9);
}

TEST(BackwardBranches, CopeWithCoincidentAndSingleNodes) {
  EXPECT_TRUE(backwardBranches({}, {}).empty());
  EXPECT_EQ(backwardBranches(test::stick(1), {false}), std::vector<double>{0});
  EXPECT_EQ(backwardBranches(test::stick(3, 0), {false, false, false}), std::vector<double>(3, 0));
}

} // namespace
} // namespace espalier
