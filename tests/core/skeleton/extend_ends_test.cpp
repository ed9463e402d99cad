#include "core/skeleton/extend_ends.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(WithExtendedEnds, ReachesToWhereThePointsEnd) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, -0.3}, {0, 0, 2.4}, 0.02, 0.01);
  const Skeleton plant = withExtendedEnds(test::stick(3), points, {0, 0, 0});
  EXPECT_NEAR(plant[NodeId{2}].position.z(), 2.4, 0.05);
  EXPECT_NEAR(plant[NodeId{0}].position.z(), -0.3, 0.05);
  EXPECT_EQ(plant[NodeId{1}], test::stick(3)[NodeId{1}]);
  EXPECT_LT(plant[NodeId{2}].position.head<2>().norm(), 1e-9);
}

TEST(WithExtendedEnds, NeverMovesFartherThanTheLastEdge) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 50}, 0.02, 0.05);
  EXPECT_NEAR(withExtendedEnds(test::stick(3), points, {0, 0, 0})[NodeId{2}].position.z(), 3, 1e-9);
}

TEST(WithExtendedEnds, NeverShortens) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0.5}, {0, 0, 1.5}, 0.02, 0.01);
  EXPECT_EQ(withExtendedEnds(test::stick(3), points, {0, 0, 0}), test::stick(3));
}

TEST(WithExtendedEnds, CopesWithNothingToDo) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  EXPECT_TRUE(withExtendedEnds({}, points, {0, 0, 0}).isEmpty());
  EXPECT_EQ(withExtendedEnds(test::stick(1), points, {0, 0, 0}), test::stick(1));
  EXPECT_EQ(withExtendedEnds(test::stick(2, 0), points, {0, 0, 0}), test::stick(2, 0));
}

} // namespace
} // namespace espalier
