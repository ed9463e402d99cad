#include "core/base/random.h"
#include "core/radius/measured_radius.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

const Eigen::Vector3d middleOfSection = Eigen::Vector3d::Zero();
constexpr double spacing = 0.02;

std::vector<MeasuredRadius> measured(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                                     const Progress& progress = {}) {
  const AssignedPoints assigned(skeleton, points, middleOfSection);
  return cylinderRadii(cylindersAbout(skeleton, assigned, {.spacing = spacing}, progress), spacing);
}

TEST(CylinderRadii, OfACylinderAreItsRadiusWhereverTheSkeletonRunsInIt) {
  Skeleton stick = test::stick(9, 0.25);
  for (const NodeId id : stick.ids()) // towards one side
    stick.setPosition(id, stick[id].position + Eigen::Vector3d(0.06, 0.02, 0));
  const auto radii = measured(stick, test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, spacing));
  for (const MeasuredRadius& each : radii) {
    EXPECT_NEAR(each.radius, 0.1, 0.001);
    EXPECT_GE(each.deviation, 0.04);
    EXPECT_LT(each.deviation, 0.1);
  }
}

TEST(CylinderRadii, AreNotPulledInByAOneSidedScan) {
  Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, spacing);
  points.row(0) = points.row(0).cwiseAbs();
  Skeleton stick = test::stick(9, 0.25);
  for (const NodeId id : stick.ids()) // at the mean of the half circle
    stick.setPosition(id, stick[id].position + Eigen::Vector3d(0.0637, 0, 0));
  for (const MeasuredRadius& each : measured(stick, points))
    EXPECT_NEAR(each.radius, 0.1, 0.005);
}

TEST(CylinderRadii, AreNoneWhereThereAreNoPoints) {
  const Skeleton stick = test::stick(9, 0.25);
  const auto radii = measured(stick, test::cylinder({0, 0, 0}, {0, 0, 0.5}, 0.1, spacing));
  EXPECT_GT(radii[0].radius, 0);
  EXPECT_EQ(radii[8].radius, 0);
  EXPECT_TRUE(measured({}, Eigen::Matrix3Xf(3, 0)).empty());
  EXPECT_EQ(measured(test::stick(1), Eigen::Matrix3Xf(3, 0))[0].radius, 0);
}

TEST(CylinderRadii, AreNotFoundOnceAskedToStop) {
  const Skeleton stick = test::stick(9, 0.25);
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, spacing);
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)measured(stick, points, progress); }));
}

/// `count` points on an upright cylinder of length 2, scattered by `error` in both directions
/// across it.
Eigen::Matrix3Xf scattered(double radius, double error, Eigen::Index count) {
  Random random(3);
  Eigen::Matrix3Xf points(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const Eigen::Vector3d place(radius * std::cos(angle) + error * random.normal(),
                                radius * std::sin(angle) + error * random.normal(),
                                random.uniform(0, 2));
    points.col(i) = place.cast<float>();
  }
  return points;
}

// Least squares alone would give 0.05 + 0.01^2 / (2 * 0.05) = 0.051.
TEST(CylinderRadii, AreNotThickerForTheScatterOfThePoints) {
  const Skeleton stick = test::stick(9, 0.25);
  double sum = 0;
  const auto radii = measured(stick, scattered(0.05, 0.01, 20'000));
  for (const MeasuredRadius& each : radii)
    sum += each.radius / static_cast<double>(radii.size());
  EXPECT_NEAR(sum, 0.05, 0.0004);
}

TEST(PointError, IsThatAcrossThickWood) {
  const Skeleton stick = test::stick(9, 0.25);
  const auto errorOf = [&](const Eigen::Matrix3Xf& points) {
    return pointError(cylindersAbout(stick, AssignedPoints(stick, points, middleOfSection),
                                     {.spacing = spacing}));
  };
  EXPECT_NEAR(errorOf(scattered(0.1, 0.005, 2000)), 0.005, 0.0005);
  EXPECT_EQ(errorOf(scattered(0.01, 0.005, 2000)), 0) << "no wood is thick enough";
  EXPECT_EQ(pointError({}), 0);
}

FittedCylinder scatteredCylinder(double radius, double error) {
  FittedCylinder cylinder;
  cylinder.radius = radius;
  cylinder.error = error;
  return cylinder;
}

// Points of 0.01 lie 0.015 off wood at most, and a little more off wood of 0.1, as 4 % is rough:
// 1.5 * hypot(0.01, 0.004) = 0.0162. Of wood of 1 it is 0.0618.
TEST(WithoutScattered, LeavesOutCylindersOfNeedles) {
  const std::vector<std::optional<FittedCylinder>> all = {
      scatteredCylinder(0.1, 0.0161), scatteredCylinder(0.1, 0.0163), std::nullopt,
      scatteredCylinder(1, 0.061), scatteredCylinder(1, 0.063)};
  const auto has = [](const std::vector<std::optional<FittedCylinder>>& cylinders) {
    std::vector<bool> result;
    for (const auto& each : cylinders)
      result.push_back(each.has_value());
    return result;
  };
  EXPECT_EQ(has(withoutScattered(all, 0.01)), (std::vector<bool>{true, false, false, true, false}));
  EXPECT_EQ(has(withoutScattered(all, 0)), has(all)) << "no error is known";
}

TEST(ThinRadii, AreDistancesWhereThereIsNoCylinder) {
  const Skeleton stick = test::stick(3);
  Eigen::Matrix3Xf points(3, 4);
  points << 0.05F, -0.05F, 0, 0, 0, 0, 0.05F, -0.05F, 2, 2, 2, 2;
  const AssignedPoints assigned(stick, points, middleOfSection);
  const MeasuredRadius known{.radius = 0.2, .deviation = 0.05};
  const auto radii = withThinRadii(stick, assigned, {known, {}, {}}, 0);
  EXPECT_EQ(radii[0].radius, 0.2) << "what is known stays";
  EXPECT_EQ(radii[0].deviation, 0.05);
  EXPECT_EQ(radii[1].radius, 0) << "it has no points";
  EXPECT_NEAR(radii[2].radius, 0.05, 1e-6);
  EXPECT_GT(radii[2].deviation, known.deviation);
}

// As thick as three errors: mean distances would be 6 % and root mean squares 11 % too long.
TEST(ThinRadii, AreNotThickerForTheScatterOfThePoints) {
  const Skeleton stick = test::stick(3);
  const AssignedPoints assigned(stick, scattered(0.03, 0.01, 20'000), middleOfSection);
  for (const MeasuredRadius& each : withThinRadii(stick, assigned, {{}, {}, {}}, 0.01))
    EXPECT_NEAR(each.radius, 0.03, 0.0005);
}

TEST(ThinRadii, AreNoThinnerThanTheErrorAllows) {
  const Skeleton stick = test::stick(3);
  const AssignedPoints assigned(stick, scattered(0.001, 0, 100), middleOfSection);
  for (const MeasuredRadius& each : withThinRadii(stick, assigned, {{}, {}, {}}, 0.01)) {
    EXPECT_GE(each.radius, 0.64 * 0.01);
    EXPECT_LT(each.radius, 0.01);
  }
}

TEST(ThinRadii, DoNotCountNeedles) {
  const Skeleton stick = test::stick(3);
  Eigen::Matrix3Xf points(3, 6);
  points << 0.05F, -0.05F, 0, 0.3F, 0, 0.4F, //
      0, 0, 0.05F, 0, -0.2F, 0,              //
      2, 2, 2, 2, 2, 2;
  const AssignedPoints assigned(stick, points, middleOfSection);
  EXPECT_NEAR(withThinRadii(stick, assigned, {{}, {}, {}}, 0)[2].radius, 0.05, 1e-6);
}

} // namespace
} // namespace espalier
