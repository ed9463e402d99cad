#include "core/align/target_sphere.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <limits>
#include <numbers>
#include <string>

namespace espalier {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const Vector3d center(501, 602, 3);
constexpr double radius = 0.07;

/// The half of a sphere that a scanner in -x sees, with noise along the beams.
std::vector<Vector3d> halfSphere(double noise, int points = 400) {
  Random random(3);
  std::vector<Vector3d> places;
  for (int i = 0; i < points; ++i) {
    Vector3d to = random.direction();
    if (to.x() > 0) to.x() *= -1;
    places.emplace_back(center + radius * to + noise * random.normal() * Vector3d::UnitX());
  }
  return places;
}

/// A branch that touches the sphere, and points all about.
std::vector<Vector3d> clutter() {
  Random random(4);
  std::vector<Vector3d> places;
  for (int i = 0; i < 300; ++i) {
    const double along = random.uniform(-0.3, 0.3);
    Vector3d across = random.direction();
    across.y() = 0;
    places.emplace_back(center + Vector3d(0, along, -0.09) + 0.015 * across.normalized());
  }
  for (int i = 0; i < 60; ++i)
    places.emplace_back(center + 0.2 * random.uniform() * random.direction());
  return places;
}

PointCloud cloudOf(std::vector<Vector3d> places, const std::vector<Vector3d>& more = {}) {
  places.insert(places.end(), more.begin(), more.end());
  RawPoints raw;
  raw.positions = std::move(places);
  return PointCloud(std::move(raw));
}

TargetSphere found(const PointCloud& cloud, const Vector3d& place,
                   const TargetSphereOptions& options = {.radius = radius, .reach = {}}) {
  return targetSphere(cloud, SpatialIndex(cloud.positions()), place, options);
}

std::string refusalOf(const PointCloud& cloud, const Vector3d& place,
                      const TargetSphereOptions& options = {.radius = radius, .reach = {}}) {
  try {
    static_cast<void>(found(cloud, place, options));
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(TargetSphere, IsFoundFromAPlaceThatIsOffByARadius) {
  const PointCloud cloud = cloudOf(halfSphere(0), clutter());
  for (const Vector3d& off : {Vector3d(0, 0, 0), Vector3d(-radius, 0, 0), Vector3d(0, radius, 0),
                              Vector3d(-0.05, 0.03, 0.05)}) {
    const TargetSphere sphere = found(cloud, center + off);
    EXPECT_LT((sphere.center - center).norm(), 1e-3 * radius) << off.transpose();
    EXPECT_EQ(sphere.radius, radius);
    EXPECT_GE(sphere.points, 400);
  }
}

TEST(TargetSphere, IsFoundWithoutItsRadius) {
  const PointCloud cloud = cloudOf(halfSphere(0), clutter());
  const TargetSphere sphere =
      found(cloud, center - Vector3d(radius, 0, 0), {.radius = {}, .reach = 0.2});
  EXPECT_LT((sphere.center - center).norm(), 0.01 * radius);
  EXPECT_NEAR(sphere.radius, radius, 0.01 * radius);
}

// 400 places off by 2 mm each: the center is off by a tenth of that in each direction, at most.
TEST(TargetSphere, AveragesNoiseOut) {
  const TargetSphere sphere = found(cloudOf(halfSphere(0.002), clutter()), center);
  EXPECT_LT((sphere.center - center).norm(), 0.0005);
  EXPECT_NEAR(sphere.residual, 0.002 / std::numbers::sqrt3, 0.0005) << "across the sphere";
}

TEST(TargetSphere, FollowsUnitAndPlace) {
  const std::vector<Vector3d> places = halfSphere(0.001);
  std::vector<Vector3d> inMillimeters;
  for (const Vector3d& place : places)
    inMillimeters.emplace_back(1000 * (place - center));
  const TargetSphere one = found(cloudOf(places), center);
  const TargetSphere other =
      found(cloudOf(inMillimeters), Vector3d::Zero(), {.radius = 1000 * radius, .reach = {}});
  EXPECT_LT((other.center - 1000 * (one.center - center)).norm(), 0.02);
  EXPECT_EQ(one.points, other.points);
}

TEST(TargetSphere, IsNotSeenInWhatIsNone) {
  const PointCloud sphere = cloudOf(halfSphere(0));
  EXPECT_THAT(refusalOf(sphere, center + Vector3d(5, 0, 0)),
              HasSubstr("no sphere of radius 0.07 about 506, 602, 3: only 0 points are near"));
  const Eigen::Matrix3Xf stem = test::cylinder({0, 0, -1}, {0, 0, 1}, radius, 0.005);
  std::vector<Vector3d> places;
  for (Eigen::Index i = 0; i < stem.cols(); ++i)
    places.emplace_back(center + stem.col(i).cast<double>());
  EXPECT_THAT(refusalOf(cloudOf(places), center), HasSubstr("lie off it")) << "a stem";
  std::vector<Vector3d> wall;
  Random random(5);
  for (int i = 0; i < 2000; ++i)
    wall.emplace_back(center + Vector3d(0, random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)));
  EXPECT_THAT(refusalOf(cloudOf(wall), center), HasSubstr("no sphere of radius")) << "a wall";
  EXPECT_THAT(refusalOf(cloudOf({center, center, center}), center), HasSubstr("no sphere"));
  EXPECT_THAT(refusalOf(cloudOf(std::vector<Vector3d>(50, center)), center),
              HasSubstr("no sphere of radius"));
}

TEST(TargetSphere, RefusesNumbersThatAreNone) {
  const PointCloud cloud = cloudOf(halfSphere(0));
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusalOf(cloud, {none, 0, 0}), HasSubstr("finite place"));
  EXPECT_THAT(refusalOf(cloud, center, {.radius = -1, .reach = {}}), HasSubstr("over 0"));
  EXPECT_THAT(refusalOf(cloud, center, {.radius = {}, .reach = none}), HasSubstr("over 0"));
  EXPECT_THAT(refusalOf(PointCloud(), center), HasSubstr("only 0 points are near"));
}

TEST(TargetSphere, StopsWhenAsked) {
  const PointCloud cloud = cloudOf(halfSphere(0));
  const SpatialIndex index(cloud.positions());
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(
        targetSphere(cloud, index, center, {.radius = radius, .reach = {}}, progress));
  }));
}

} // namespace
} // namespace espalier
