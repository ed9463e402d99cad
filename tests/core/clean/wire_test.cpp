#include "core/base/random.h"
#include "core/clean/wire.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

const WireOptions wireOptions{.tolerance = 0.02, .gap = 0.3, .mostSag = 0.2, .leastLength = 2};

/// z = height + a (cosh((x - x0) / a) - 1), turned about z.
struct Hanging {
  double a = 4, x0 = 0.3, height = 2;
  Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();

  [[nodiscard]] Eigen::Vector3d at(double x) const {
    return turn * Eigen::Vector3d(x, 0.4, height + a * (std::cosh((x - x0) / a) - 1));
  }
  [[nodiscard]] Eigen::Matrix3Xf points(double from, double to, int count) const {
    Random random(2);
    Eigen::Matrix3Xf result(3, count);
    for (Eigen::Index i = 0; i < count; ++i)
      result.col(i) = (at(random.uniform(from, to)) + 0.002 * random.direction()).cast<float>();
    return result;
  }
};

Eigen::Matrix3Xf wireAndPlant() {
  return test::both(Hanging().points(-2, 2.5, 1500), test::forkCloud());
}

TEST(Wire, IsFollowedFromTwoPlacesOnIt) {
  const Hanging truth;
  const auto found = wireBetween(wireAndPlant(), truth.at(-1), truth.at(1), wireOptions);
  ASSERT_TRUE(found);
  EXPECT_LT((found->from - truth.at(-2)).norm(), 0.05);
  EXPECT_LT((found->to - truth.at(2.5)).norm(), 0.05);
  EXPECT_LT(found->error, 0.004);
  EXPECT_GT(found->filled, 0.95);
  std::size_t own = 0;
  for (const Eigen::Index point : found->points)
    own += point < 1500 ? 1 : 0;
  EXPECT_GT(own, 1490U);
  EXPECT_LT(found->points.size() - own, 40U) << "where it passes by the plant";
}

// By the formula: the chord at the middle less the curve there, where the slope is that of the
// chord.
TEST(Wire, SagsAsItHangs) {
  Hanging truth;
  truth.x0 = 0;
  const auto found =
      wireBetween(truth.points(-2, 2, 1500), truth.at(-1.5), truth.at(1.5), wireOptions);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->sag, truth.a * (std::cosh(2 / truth.a) - 1), 0.01);
}

TEST(Wire, MayBeStraight) {
  Eigen::Matrix3Xf line(3, 800);
  for (Eigen::Index i = 0; i < 800; ++i)
    line.col(i) = Eigen::Vector3f(static_cast<float>(i) / 200, 0, 1 + static_cast<float>(i) / 800);
  const auto found = wireBetween(line, {0.5, 0, 1.125}, {3, 0, 1.75}, wireOptions);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->points.size(), 800U);
  EXPECT_NEAR(found->sag, 0, 0.005);
}

TEST(Wire, IsNoneWithoutPointsBetween) {
  const Eigen::Matrix3Xf points = wireAndPlant();
  EXPECT_FALSE(wireBetween(points, {0, 5, 1}, {3, 5, 1}, wireOptions));
  EXPECT_FALSE(wireBetween(points, {1, 1, 1}, {1, 1, 2}, wireOptions)) << "above each other";
  EXPECT_FALSE(wireBetween(Eigen::Matrix3Xf(3, 0), {0, 0, 0}, {1, 0, 0}, wireOptions));
}

TEST(Wire, IsSearchedForAndABranchIsNone) {
  const Hanging truth;
  const std::vector<Wire> found = wiresIn(wireAndPlant(), wireOptions);
  ASSERT_EQ(found.size(), 1U);
  const auto& wire = found.front();
  const double apart = std::min((wire.from - truth.at(-2)).norm(), (wire.to - truth.at(-2)).norm());
  EXPECT_LT(apart, 0.1);
  EXPECT_NEAR((wire.to - wire.from).norm(), (truth.at(2.5) - truth.at(-2)).norm(), 0.1);
  EXPECT_TRUE(wiresIn(test::forkCloud(), wireOptions).empty());
  EXPECT_TRUE(wiresIn(Eigen::Matrix3Xf(3, 0), wireOptions).empty());
}

TEST(Wire, IsFoundInAScanThatLies) {
  const Eigen::Matrix3Xf points = wireAndPlant();
  const auto laid = [](const Eigen::Vector3d& place) {
    return Eigen::Vector3d(place.z() - 50, place.x() + 7, place.y());
  };
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.push_back(laid(points.col(i).cast<double>()));
  const PointCloud cloud(std::move(raw));
  const PlantScale scale{.spacing = 0.01, .height = 3};
  const PointSet found = wirePointsBetween(cloud, {}, UpAxis::x, scale, laid(Hanging().at(-1)),
                                           laid(Hanging().at(1)), wireOptions);
  EXPECT_NEAR(static_cast<double>(found.size()), 1500, 40);
}

TEST(Wire, StopsWhenAsked) {
  const Eigen::Matrix3Xf points = wireAndPlant();
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)wireBetween(points, Hanging().at(-1), Hanging().at(1), wireOptions, progress);
  }));
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)wiresIn(points, wireOptions, progress); }));
}

} // namespace
} // namespace espalier
