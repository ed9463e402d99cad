#include "core/radius/assigned_radii.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(MeanPointDistances, OfACylinderAreItsRadius) {
  const Skeleton stick = test::stick(5, 0.5);
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.07, 0.02);
  for (const double distance : meanPointDistances(stick, points, Eigen::Vector3d::Zero()))
    EXPECT_NEAR(distance, 0.07, 1e-5);
}

TEST(MeanPointDistances, AreZeroWhereThereAreNoPoints) {
  const Skeleton stick = test::stick(5, 0.5);
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 0.7}, 0.07, 0.02);
  const std::vector<double> distances = meanPointDistances(stick, points, {0, 0, 0});
  EXPECT_GT(distances[1], 0);
  EXPECT_EQ(distances[3], 0);
  EXPECT_TRUE(meanPointDistances({}, points, {0, 0, 0}).empty());
}

} // namespace
} // namespace espalier
