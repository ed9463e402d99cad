#include "core/cloud/middle_of_nearest.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// Columns at x = 0, 1, 2 ... 9.
Eigen::Matrix3Xf row() {
  Eigen::Matrix3Xf points = Eigen::Matrix3Xf::Zero(3, 10);
  for (int i = 0; i < 10; ++i)
    points(0, i) = static_cast<float>(i);
  return points;
}

const Eigen::Vector3d origin(1000, 0, 0);

TEST(MiddleOfNearest, IsThatOfFivePoints) {
  const auto found = middleOfNearest(row(), origin, {}, {1004.1, 3, 0}, 100);
  ASSERT_TRUE(found); // 2 to 6
  EXPECT_TRUE(found->isApprox(Eigen::Vector3d(1004, 0, 0)));
}

TEST(MiddleOfNearest, IsThatOfFewerWhereNoMoreAreWithinReach) {
  const auto found = middleOfNearest(row(), origin, {}, {1004.4, 0, 0}, 1);
  ASSERT_TRUE(found); // 4 and 5
  EXPECT_TRUE(found->isApprox(Eigen::Vector3d(1004.5, 0, 0)));
  EXPECT_FALSE(middleOfNearest(row(), origin, {}, {1004, 50, 0}, 10));
  EXPECT_FALSE(middleOfNearest(Eigen::Matrix3Xf(3, 0), origin, {}, origin, 10));
}

TEST(MiddleOfNearest, CountsNoPointThatIsSetAside) {
  const auto found =
      middleOfNearest(row(), origin, PointSet::of({0, 1, 2, 3, 4}), {1000, 0, 0}, 100);
  ASSERT_TRUE(found); // 5 to 9
  EXPECT_TRUE(found->isApprox(Eigen::Vector3d(1007, 0, 0)));
  EXPECT_FALSE(middleOfNearest(row(), origin, PointSet::firstOf(10), {1000, 0, 0}, 100));
}

} // namespace
} // namespace espalier
