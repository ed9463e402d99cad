#include "core/base/random.h"
#include "core/clean/ground.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// Ground that rises along x, with a swell, and boxes of points above it.
struct Hillside {
  Eigen::Matrix3Xf points;
  Eigen::Index onGround = 0; // the first of them

  explicit Hillside(double slope, bool hasHole = false) {
    Random random(5);
    std::vector<Eigen::Vector3f> ground;
    std::vector<Eigen::Vector3f> above;
    const auto height = [&](double x, double y) { return slope * x + 0.1 * std::sin(y); };
    while (ground.size() < 20000) {
      const double x = random.uniform(-5, 5);
      const double y = random.uniform(-5, 5);
      if (hasHole && std::hypot(x, y) < 0.8) continue;
      ground.emplace_back(
          Eigen::Vector3d(x, y, height(x, y) + 0.005 * random.normal()).cast<float>());
    }
    while (above.size() < 5000) { // a crown
      const double x = random.uniform(-2, 2);
      const double y = random.uniform(-2, 2);
      above.emplace_back(Eigen::Vector3d(x, y, height(x, y) + random.uniform(1, 3)).cast<float>());
    }
    onGround = std::ssize(ground);
    ground.insert(ground.end(), above.begin(), above.end());
    points.resize(3, std::ssize(ground));
    for (std::size_t i = 0; i < ground.size(); ++i)
      points.col(static_cast<Eigen::Index>(i)) = ground[i];
  }
};

const GroundOptions clothOptions{.cell = 0.15, .tolerance = 0.06};

/// Shares of the ground below the tolerance, and of what is above it.
std::pair<double, double> sharesBelow(const Hillside& hill) {
  const std::vector<float> heights =
      heightsAbove(groundBelow(hill.points, clothOptions), hill.points);
  double ground = 0;
  double above = 0;
  for (Eigen::Index i = 0; i < hill.points.cols(); ++i)
    if (static_cast<double>(heights[static_cast<std::size_t>(i)]) <= clothOptions.tolerance)
      ++(i < hill.onGround ? ground : above);
  return {ground / static_cast<double>(hill.onGround),
          above / static_cast<double>(hill.points.cols() - hill.onGround)};
}

TEST(Ground, IsFoundOnLevelGroundAndOnSlopes) {
  for (const double slope : {0.0, 0.2, 0.6, 1.0}) {
    const auto [ground, above] = sharesBelow(Hillside(slope));
    EXPECT_GT(ground, 0.99) << slope;
    EXPECT_EQ(above, 0) << slope;
  }
}

TEST(Ground, GoesOnBelowWhatHidesIt) {
  const auto [ground, above] = sharesBelow(Hillside(0.2, true));
  EXPECT_GT(ground, 0.99);
  EXPECT_EQ(above, 0);
}

TEST(Ground, IsNotDrawnDownByStrays) {
  Hillside hill(0.2);
  Eigen::Matrix3Xf strays(3, 8);
  for (Eigen::Index i = 0; i < strays.cols(); ++i)
    strays.col(i) = Eigen::Vector3f(static_cast<float>(i) - 3.7F, 0.3F, -4);
  hill.points = test::both(hill.points, strays);
  const auto [ground, above] = sharesBelow(hill);
  EXPECT_GT(ground, 0.99);
  EXPECT_NEAR(above, 8 / 5008.0, 1e-9) << "strays below the ground go with it";
}

// So many that some lie three by three, as in the scan of a plot.
TEST(Ground, IsNotDrawnDownByManyStraysBelowDenseGround) {
  constexpr Eigen::Index ground = 100000;
  constexpr Eigen::Index strays = 150;
  Random random(5);
  Eigen::Matrix3Xf points(3, ground + strays);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double x = random.uniform(-5, 5);
    const double y = random.uniform(-5, 5);
    const double height = i < ground ? 0.2 * x + 0.1 * std::sin(y) + 0.005 * random.normal()
                                     : random.uniform(-4, -1.2);
    points.col(i) = Eigen::Vector3d(x, y, height).cast<float>();
  }
  const GroundOptions options{.cell = 0.3, .tolerance = 0.06};
  const std::vector<float> heights = heightsAbove(groundBelow(points, options), points);
  const auto found = std::count_if(heights.begin(), heights.begin() + ground,
                                   [](float height) { return std::abs(height) <= 0.06F; });
  EXPECT_GT(static_cast<double>(found) / static_cast<double>(ground), 0.99);
}

TEST(Ground, IsTheSameMovedAndInAnotherUnit) {
  const Hillside hill(0.3);
  Eigen::Matrix3Xf moved = 1000 * hill.points;
  moved.colwise() += Eigen::Vector3f(5000, -3000, 100);
  const std::vector<float> heights =
      heightsAbove(groundBelow(hill.points, clothOptions), hill.points);
  const std::vector<float> other =
      heightsAbove(groundBelow(moved, {.cell = 150, .tolerance = 60}), moved);
  for (std::size_t i = 0; i < heights.size(); i += 37)
    EXPECT_NEAR(other[i] / 1000, heights[i], 0.01) << i;
}

TEST(Ground, TakesAnyPoints) {
  EXPECT_EQ(groundBelow(Eigen::Matrix3Xf(3, 0), clothOptions).heights.size(), 0);
  const Eigen::Matrix3Xf one = Eigen::Vector3f(1, 2, 3);
  EXPECT_NEAR(heightsAbove(groundBelow(one, clothOptions), one).front(), 0, 0.2);
  const Eigen::Matrix3Xf same = Eigen::Vector3f(1, 2, 3).replicate(1, 50);
  EXPECT_NEAR(heightsAbove(groundBelow(same, clothOptions), same).front(), 0, 1e-5);
  Eigen::Matrix3Xf wide(3, 3); // cells for all of this would not fit
  wide << 0, 1e7F, 2, 0, 1e7F, 2, 0, 0, 0;
  EXPECT_EQ(heightsAbove(groundBelow(wide, {.cell = 0.001, .tolerance = 1}), wide).size(), 3U);
}

TEST(Ground, StopsWhenAsked) {
  const Hillside hill(0);
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)groundBelow(hill.points, clothOptions, progress); }));
}

} // namespace
} // namespace espalier
