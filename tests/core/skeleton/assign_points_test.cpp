#include "core/skeleton/assign_points.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

Eigen::Matrix3Xf place(float x, float y, float z) {
  return Eigen::Vector3f(x, y, z);
}

TEST(AssignPoints, FindsThePlaceOnTheNearestEdge) {
  const PointOnSkeleton found =
      assignPoints(place(0.3F, 0, 0.25F), {0, 0, 2}, test::stick(5)).front();
  EXPECT_EQ(found.child, NodeId{3}); // from 2 to 3
  EXPECT_NEAR(found.fraction, 0.25, 1e-6);
  EXPECT_NEAR(found.distance, 0.3, 1e-6);
}

TEST(AssignPoints, ClampsToTheEnds) {
  const PointOnSkeleton found = assignPoints(place(0, 0, 7), {0, 0, 0}, test::stick(5)).front();
  EXPECT_EQ(found.child, NodeId{4});
  EXPECT_EQ(found.fraction, 1);
  EXPECT_NEAR(found.distance, 3, 1e-6);
}

TEST(AssignPoints, CopesWithASingleNode) {
  const PointOnSkeleton found = assignPoints(place(0, 3, 0), {0, 0, 0}, test::stick(1)).front();
  EXPECT_EQ(found.child, test::forkRoot);
  EXPECT_NEAR(found.distance, 3, 1e-6);
}

TEST(AssignPoints, ToAnEdgeWithoutLengthGiveItsEnd) {
  const PointOnSkeleton found = assignPoints(place(0, 3, 0), {0, 0, 0}, test::stick(2, 0)).front();
  EXPECT_EQ(found.child, NodeId{1});
  EXPECT_EQ(found.fraction, 1);
}

} // namespace
} // namespace espalier
