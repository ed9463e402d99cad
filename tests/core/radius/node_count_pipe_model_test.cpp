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

// A stick of 6 with two more tips: nodes 0, 1, 2, 3 carry 8, 7, 6, 5 of 8; half is 4. Radii of tips
// are 1, 2 and 3; those about the foot follow 2 n^e with e = 1, but for one that is far off.
TEST(PipeEndRadii, LeadFromTheTipsThroughTheFootToTheRoot) {
  Skeleton plant = test::stick(6);
  plant.add({.parent = NodeId{3}});
  plant.add({.parent = NodeId{4}});
  const NodeCountPipeOptions ends = pipeEndRadii(plant, {0, 14, 12, 90, 2, 1, 3, 2});
  EXPECT_NEAR(ends.rootRadius, 16, 1e-9);
  EXPECT_EQ(ends.apexRadius, 2);
}

TEST(PipeEndRadii, GiveBackTheLawThatRadiiFollow) {
  const NodeCountPipeOptions law{.rootRadius = 0.9, .apexRadius = 0.1};
  const Skeleton plant = withNodeCountPipeRadii(test::fork(6), law);
  std::vector<double> measured(plant.idEnd(), 0);
  for (const NodeId id : plant.ids())
    if (id != test::forkRoot) measured[indexOf(id)] = plant[id].radius;
  const NodeCountPipeOptions ends = pipeEndRadii(plant, measured);
  EXPECT_NEAR(ends.rootRadius, 0.9, 1e-9) << "though the root was not measured";
  EXPECT_NEAR(ends.apexRadius, 0.1, 1e-12);
}

TEST(PipeEndRadii, NeverGrowTowardsTheTips) {
  const NodeCountPipeOptions ends = pipeEndRadii(test::stick(4), {1, 1, 1, 5});
  EXPECT_LE(ends.apexRadius, ends.rootRadius);
}

} // namespace
} // namespace espalier
