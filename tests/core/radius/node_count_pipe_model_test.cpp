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

TEST(NodeCountPipeModel, GivesNoRadiiWithoutAnApexRadius) {
  const Skeleton plant = withNodeCountPipeRadii(test::fork(3), {.rootRadius = 1, .apexRadius = 0});
  for (const NodeId id : plant.ids())
    EXPECT_EQ(plant[id].radius, 0);
}

TEST(CarriedNodes, CountEachNodeAndAllThatItCarries) {
  EXPECT_EQ(carriedNodes(test::fork(2)), (std::vector<double>{4, 3, 1, 1}));
  EXPECT_TRUE(carriedNodes({}).empty());
}

} // namespace
} // namespace espalier
