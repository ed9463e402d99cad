#include "core/base/random.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/thin_wood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace espalier {
namespace {

/// Points all over an upright cylinder 1000 spacings high, about one per square of a spacing.
Eigen::Matrix3Xf cylinder(double diameter) {
  const double around = std::numbers::pi * diameter;
  const auto count = static_cast<Eigen::Index>(1000 * std::max(around, 1.0));
  Random random(1);
  Eigen::Matrix3Xf points(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * random.uniform();
    points.col(i) = Eigen::Vector3d(diameter / 2 * std::cos(turn), diameter / 2 * std::sin(turn),
                                    1000 * random.uniform())
                        .cast<float>();
  }
  return points;
}

std::vector<Eigen::Index> all(const Eigen::Matrix3Xf& points) {
  std::vector<Eigen::Index> places(static_cast<std::size_t>(points.cols()));
  std::iota(places.begin(), places.end(), 0);
  return places;
}

double thicknessOf(const Eigen::Matrix3Xf& points, double spacing) {
  return thinWood(points, SpatialIndex(points), all(points), spacing).thickness;
}

TEST(ThinWood, IsAsThickAsItsPointsSay) {
  for (const double diameter : {1.0, 1.5, 2.0, 3.0, 6.0, 12.0})
    EXPECT_NEAR(thicknessOf(cylinder(diameter), 1), diameter, 0.2 * diameter) << diameter;
}

TEST(ThinWood, IsAtMostWhatCanBeToldApart) {
  EXPECT_EQ(thicknessOf(cylinder(40), 1), thickestThinWood);
  EXPECT_EQ(thicknessOf(cylinder(12).leftCols(10), 1), thickestThinWood) << "few points";
}

TEST(ThinWood, HasNoThicknessOnALine) {
  EXPECT_LT(thicknessOf(cylinder(0.01), 1), 0.1);
}

Eigen::Matrix3Xf withNoise(Eigen::Matrix3Xf points, double noise) {
  Random random(2);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    for (int axis = 0; axis < 2; ++axis)
      points(axis, i) += static_cast<float>(noise * random.normal());
  return points;
}

TEST(ThinWood, GrowsWithTheNoise) {
  EXPECT_GT(thicknessOf(withNoise(cylinder(0.5), 1), 1), 2);
}

TEST(ThinWood, SaysHowThePointsScatter) {
  const auto scatterOf = [](const Eigen::Matrix3Xf& points) {
    return thinWood(points, SpatialIndex(points), all(points), 1).scatter;
  };
  EXPECT_LT(scatterOf(cylinder(3)), 0.1);
  EXPECT_NEAR(scatterOf(withNoise(cylinder(3), 0.3)), 0.3, 0.1);
  EXPECT_NEAR(scatterOf(withNoise(cylinder(12), 0.6)), 0.6, 0.15);
  EXPECT_EQ(scatterOf(cylinder(3).leftCols(10)), 0) << "few points";
}

TEST(ThinWood, FollowsTheUnit) {
  const Eigen::Matrix3Xf points = cylinder(2);
  EXPECT_NEAR(thicknessOf(1000 * points, 1000), 1000 * thicknessOf(points, 1), 1);
}

} // namespace
} // namespace espalier
