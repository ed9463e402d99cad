#include "core/radius/node_count_pipe_model.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

// forkRoot carries 8 nodes, forkTop 7, each of 6 shoots itself: with 8 times the apex radius at the
// root, the exponent is 1 and radii are proportional to what is carried.
TEST(NodeCountPipeModel, FollowsWhatEachNodeCarries) {
  const Skeleton plant =
      withNodeCountPipeRadii(test::fork(6), {.rootRadius = 0.8, .apexRadius = 0.1});
  EXPECT_NEAR(plant[test::forkRoot].radius, 0.8, 1e-12);
  EXPECT_NEAR(plant[test::forkTop].radius, 0.7, 1e-12);
  EXPECT_NEAR(plant[NodeId{5}].radius, 0.1, 1e-12);
}

TEST(NodeCountPipeModel, GivesASingleNodeTheApexRadius) {
  const Skeleton plant = withNodeCountPipeRadii(test::stick(1), {.rootRadius = 2, .apexRadius = 1});
  EXPECT_EQ(plant[test::forkRoot].radius, 1);
  EXPECT_TRUE(withNodeCountPipeRadii({}, {.rootRadius = 2, .apexRadius = 1}).isEmpty());
}

TEST(PipeEndRadii, AreMediansAtTheFootAndTheTips) {
  // A stick of 6 with two more tips: nodes 0, 1, 2, 3 carry 8, 7, 6, 5 of 8; half is 4.
  Skeleton plant = test::stick(6);
  plant.add({.parent = NodeId{3}});
  plant.add({.parent = NodeId{4}});
  const NodeCountPipeOptions ends = pipeEndRadii(plant, {9, 5, 6, 0, 2, 1, 3, 2});
  EXPECT_EQ(ends.rootRadius, 6);
  EXPECT_EQ(ends.apexRadius, 2);
}

TEST(PipeEndRadii, NeverGrowTowardsTheTips) {
  const NodeCountPipeOptions ends = pipeEndRadii(test::stick(4), {1, 1, 1, 5});
  EXPECT_LE(ends.apexRadius, ends.rootRadius);
}

} // namespace
} // namespace espalier
