#include "core/base/circle_fit.h"
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

/// Points on the part of a circle about (3, -2) of radius 0.5 that `arc` radians span.
std::vector<Eigen::Vector2d> arcPoints(double arc, double noise, int count = 200) {
  Random random(1);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = arc * i / count;
    const double radius = 0.5 + noise * random.normal();
    points.emplace_back(3 + radius * std::cos(angle), -2 + radius * std::sin(angle));
  }
  return points;
}

TEST(FitCircle, IsExactOnPointsOfACircle) {
  for (const double arc : {0.4, 1.0, 3.0, 2 * std::numbers::pi}) {
    const auto circle = fitCircle(arcPoints(arc, 0));
    ASSERT_TRUE(circle);
    EXPECT_LT((circle->center - Eigen::Vector2d(3, -2)).norm(), 1e-8);
    EXPECT_NEAR(circle->radius, 0.5, 1e-8);
    EXPECT_NEAR(circle->error, 0, 1e-8);
    // An arc may touch one more of the 16 sectors at either end.
    EXPECT_NEAR(circle->coverage, arc / (2 * std::numbers::pi), 2.0 / 16);
  }
}

TEST(FitCircle, FindsTheAxisOfAHalfScannedStem) {
  const auto circle = fitCircle(arcPoints(std::numbers::pi, 0.01));
  ASSERT_TRUE(circle);
  EXPECT_LT((circle->center - Eigen::Vector2d(3, -2)).norm(), 0.01);
  EXPECT_NEAR(circle->radius, 0.5, 0.01);
  EXPECT_NEAR(circle->error, 0.01, 0.003);
}

TEST(FitCircle, IsNoneForPointsOnALineOrTooFew) {
  EXPECT_FALSE(fitCircle({{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
  EXPECT_FALSE(fitCircle({{0, 0}, {1, 1}}));
  EXPECT_FALSE(fitCircle(std::vector<Eigen::Vector2d>(9, {1, 1})));
}

} // namespace
} // namespace espalier
