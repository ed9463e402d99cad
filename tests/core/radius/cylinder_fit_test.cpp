#include "core/base/random.h"
#include "core/radius/cylinder_fit.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double pi = std::numbers::pi;

/// `count` points on an upright cylinder of radius 10 about (3, 4), 40 high, on an arc of it.
std::vector<Eigen::Vector3d> wood(int count, double arc, double noise = 0) {
  Random random(5);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double turn = arc * random.uniform();
    const double radius = 10 + noise * random.normal();
    points.emplace_back(3 + radius * std::cos(turn), 4 + radius * std::sin(turn),
                        40 * random.uniform());
  }
  return points;
}

FittedCylinder guess() {
  FittedCylinder start;
  start.point = {1, 6, 10};
  start.direction = Eigen::Vector3d(0.1, -0.15, 1).normalized();
  start.radius = 7;
  return start;
}

double distanceToAxis(const FittedCylinder& cylinder, const Eigen::Vector3d& place) {
  return (place - cylinder.point).cross(cylinder.direction).norm();
}

TEST(FitCylinder, FindsAnExactOneFromAPoorGuess) {
  const auto fit = fitCylinder(wood(300, 2 * pi), guess());
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->radius, 10, 1e-6);
  EXPECT_NEAR(std::abs(fit->direction.z()), 1, 1e-9);
  EXPECT_NEAR(distanceToAxis(*fit, {3, 4, 0}), 0, 1e-6);
  EXPECT_NEAR(fit->error, 0, 1e-6);
  EXPECT_EQ(fit->coverage, 1);
  EXPECT_EQ(fit->kept, 1);
}

TEST(FitCylinder, FindsAHalfScannedOneInNoise) {
  const auto fit = fitCylinder(wood(600, pi, 0.3), guess());
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->radius, 10, 0.3);
  EXPECT_NEAR(fit->error, 0.3, 0.06);
  EXPECT_NEAR(fit->coverage, 0.5, 0.1);
}

TEST(FitCylinder, LeavesOutStrayPoints) {
  std::vector<Eigen::Vector3d> points = wood(400, 2 * pi, 0.1);
  Random random(9);
  for (int i = 0; i < 100; ++i) // a twig beside it
    points.emplace_back(17 + random.normal(), 12 + random.normal(), 40 * random.uniform());
  const auto fit = fitCylinder(points, guess());
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->radius, 10, 0.1);
  EXPECT_NEAR(fit->kept, 0.8, 0.05);
}

TEST(FitCylinder, MovesTurnsAndScalesWithThePoints) {
  const Eigen::AngleAxisd turn(1, Eigen::Vector3d(1, 2, 3).normalized());
  std::vector<Eigen::Vector3d> points = wood(300, 1.3 * pi, 0.1);
  const auto plain = fitCylinder(points, guess());
  FittedCylinder start = guess();
  const Eigen::Vector3d far(500, -300, 20);
  for (Eigen::Vector3d& point : points)
    point = far + 0.001 * (turn * point);
  start.point = far + 0.001 * (turn * start.point);
  start.direction = turn * start.direction;
  start.radius *= 0.001;
  const auto moved = fitCylinder(points, start);
  ASSERT_TRUE(plain && moved);
  EXPECT_NEAR(moved->radius, 0.001 * plain->radius, 1e-8);
  EXPECT_NEAR(moved->error, 0.001 * plain->error, 1e-8);
}

TEST(FitCylinder, IsNoneForFewPointsOrPointsInOnePlace) {
  EXPECT_FALSE(fitCylinder({}, guess()));
  EXPECT_FALSE(fitCylinder(wood(7, 2 * pi), guess()));
  EXPECT_FALSE(fitCylinder(std::vector<Eigen::Vector3d>(50, Eigen::Vector3d(1, 1, 1)), guess()));
}

TEST(FitCylinder, IsNoneOrWideOnAFlatSheet) {
  std::vector<Eigen::Vector3d> sheet;
  Random random(2);
  for (int i = 0; i < 400; ++i)
    sheet.emplace_back(20 * random.uniform(), 0, 40 * random.uniform());
  const auto fit = fitCylinder(sheet, guess());
  EXPECT_TRUE(!fit || fit->coverage < 0.3);
}

} // namespace
} // namespace espalier
