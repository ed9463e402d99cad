#include "core/base/quantile.h"
#include "core/base/random.h"
#include "core/cloud/wood_around.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

constexpr double turn = 2 * std::numbers::pi;

struct ScannedCylinder {
  double radius = 4;
  double arc = turn;    // of its surface that is seen [rad]
  double noise = 0;     // across it, in both directions
  double density = 1;   // points per unit of its surface
  double length = 1000; // along z
};

Eigen::Matrix3Xf scanned(const ScannedCylinder& cylinder) {
  Random random(1);
  const double area = cylinder.arc * cylinder.radius * cylinder.length;
  Eigen::Matrix3Xf points(3, static_cast<Eigen::Index>(area * cylinder.density));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double at = cylinder.arc * random.uniform();
    const double x = cylinder.radius * std::cos(at) + cylinder.noise * random.normal();
    const double y = cylinder.radius * std::sin(at) + cylinder.noise * random.normal();
    points.col(i) = Eigen::Vector3d(x, y, cylinder.length * random.uniform()).cast<float>();
  }
  return points;
}

/// The medians of what is seen at 200 places away from the ends.
WoodAround seenOn(const Eigen::Matrix3Xf& points, double spacing, double farthest = 32) {
  const SpatialIndex index(points);
  std::vector<double> thicknesses;
  std::vector<double> scatters;
  std::vector<double> arcs;
  const float top = points.row(2).maxCoeff();
  for (Eigen::Index i = 0; i < points.cols(); i += points.cols() / 200 + 1) {
    if (points(2, i) < 0.1F * top || points(2, i) > 0.9F * top) continue;
    const WoodAround wood = woodAround(points, index, i, spacing, {.farthest = farthest});
    if (wood.thickness) thicknesses.push_back(*wood.thickness);
    if (wood.scatter) scatters.push_back(*wood.scatter);
    if (wood.arc) arcs.push_back(*wood.arc);
  }
  return {quantile(thicknesses, 0.5), quantile(scatters, 0.5), quantile(arcs, 0.5)};
}

TEST(WoodAround, IsAsThickAsTheCylinder) {
  for (const double radius : {0.5, 1.0, 2.0, 4.0, 7.0}) {
    const WoodAround wood = seenOn(scanned({.radius = radius}), 1);
    ASSERT_TRUE(wood.thickness) << radius;
    EXPECT_NEAR(*wood.thickness, 2 * radius, 0.1 * 2 * radius) << radius;
  }
}

/// At how many of 200 places a thickness is measured.
double toldOn(const Eigen::Matrix3Xf& points, const WoodLook& look) {
  const SpatialIndex index(points);
  int measured = 0;
  for (Eigen::Index i = 0; i < 200; ++i)
    measured += woodAround(points, index, i * points.cols() / 200, 1, look).thickness.has_value();
  return measured / 200.0;
}

TEST(WoodAround, DoesNotSayHowThickWoodIsThatIsLargerThanItsBalls) {
  EXPECT_GT(toldOn(scanned({.radius = 4}), {}), 0.95);
  EXPECT_LT(toldOn(scanned({.radius = 4}), {.farthest = 8}), 0.05);
  EXPECT_LT(toldOn(scanned({.radius = 30, .length = 300}), {}), 0.05);
}

TEST(WoodAround, TakesFewPointsThatLieOnALineByChanceForNoWood) {
  const Eigen::Matrix3Xf trunk = scanned({.radius = 30, .density = 0.25, .length = 300});
  EXPECT_GT(toldOn(trunk, {.confirms = false}), 0.05);
  EXPECT_LT(toldOn(trunk, {}), 0.03);
}

TEST(WoodAround, ScattersAsItsPointsDo) {
  for (const double noise : {0.1, 0.3, 0.6}) {
    const WoodAround wood = seenOn(scanned({.radius = 4, .noise = noise}), 1);
    ASSERT_TRUE(wood.scatter) << noise;
    EXPECT_NEAR(*wood.scatter, noise, 0.25 * noise) << noise;
  }
}

TEST(WoodAround, ScattersByLittleWithoutNoise) {
  for (const double radius : {1.0, 4.0, 30.0})
    EXPECT_LT(seenOn(scanned({.radius = radius, .length = 300}), 1).scatter.value_or(1), 0.1)
        << radius;
}

// No circle is left to be seen: the moments show the noise all the same.
TEST(WoodAround, ScattersMoreThanTheWoodIsThick) {
  for (const double noise : {1.0, 2.0}) {
    const WoodAround wood = seenOn(scanned({.radius = 0.5, .noise = noise, .density = 8}), 1);
    ASSERT_TRUE(wood.scatter) << noise;
    EXPECT_NEAR(*wood.scatter, noise, 0.2 * noise) << noise;
    ASSERT_TRUE(wood.thickness) << noise;
    EXPECT_NEAR(*wood.thickness, 2 * std::sqrt(0.25 + 2 * noise * noise), 0.2 * 3 * noise) << noise;
  }
}

TEST(WoodAround, ScattersByUpToAThirdTooLittleWhereNoiseIsWidest) {
  const WoodAround wood = seenOn(scanned({.radius = 0.5, .noise = 4, .density = 8}), 1);
  ASSERT_TRUE(wood.scatter);
  EXPECT_NEAR(*wood.scatter, 0.83 * 4, 0.17 * 4);
}

TEST(WoodAround, IsSeenAsFarAroundAsThereArePoints) {
  for (const double degrees : {90.0, 180.0, 270.0, 360.0}) {
    const WoodAround wood =
        seenOn(scanned({.radius = 4, .arc = turn * degrees / 360, .noise = 0.1}), 1);
    ASSERT_TRUE(wood.arc) << degrees;
    EXPECT_NEAR(*wood.arc * 360 / turn, degrees, 360.0 / 16) << degrees;
  }
}

TEST(WoodAround, ShowsNoArcOfThinWoodNorOfNoise) {
  EXPECT_FALSE(seenOn(scanned({.radius = 0.7}), 1).arc);
  EXPECT_FALSE(seenOn(scanned({.radius = 0.5, .noise = 3, .density = 8}), 1).arc);
}

// A second cylinder stands a few diameters off: balls that hold both show no line, but for what is
// joined with the place.
TEST(WoodAround, PassesOverOtherWoodInLargeBalls) {
  const Eigen::Matrix3Xf one = scanned({.radius = 4});
  Eigen::Matrix3Xf two(3, 2 * one.cols());
  two << one, one.colwise() + Eigen::Vector3f(15, 0, 0);
  const WoodAround wood = seenOn(two, 1);
  ASSERT_TRUE(wood.thickness);
  EXPECT_NEAR(*wood.thickness, 8, 1);
}

TEST(WoodAround, FollowsTheUnit) {
  const Eigen::Matrix3Xf points = scanned({.radius = 2, .noise = 0.2});
  const WoodAround wood = seenOn(points, 1);
  const WoodAround scaled = seenOn(1000 * points, 1000);
  ASSERT_TRUE(wood.thickness && wood.scatter && wood.arc);
  EXPECT_NEAR(*scaled.thickness, 1000 * *wood.thickness, 0.5);
  EXPECT_NEAR(*scaled.scatter, 1000 * *wood.scatter, 0.5);
  EXPECT_DOUBLE_EQ(*scaled.arc, *wood.arc);
}

TEST(WoodAround, IsUnknownAroundFewPointsAndAroundOnePlace) {
  const Eigen::Matrix3Xf few = Eigen::Matrix3Xf::Random(3, 5);
  const WoodAround wood = woodAround(few, SpatialIndex(few), 0, 1);
  EXPECT_FALSE(wood.thickness);
  EXPECT_FALSE(wood.scatter);
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 100);
  EXPECT_EQ(woodAround(same, SpatialIndex(same), 0, 1).arc, std::nullopt);
}

} // namespace
} // namespace espalier
