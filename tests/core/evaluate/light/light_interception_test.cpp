#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/light/light_interception.h"
#include "core/evaluate/light/sky.h"
#include "core/surface/generalized_cylinders.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stop_token>

namespace espalier {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A plane quadrangle, two triangles.
void addQuadrangle(SurfaceMesh& mesh, const std::array<Eigen::Vector3d, 4>& corners) {
  const int first = static_cast<int>(mesh.corners.size());
  mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// A flat rectangle at height z from x.
void addPlate(SurfaceMesh& mesh, double width, double depth, double z, double x = 0) {
  addQuadrangle(mesh, {{{x, 0, z}, {x + width, 0, z}, {x + width, depth, z}, {x, depth, z}}});
}

SurfaceMesh unitCube() {
  const auto corner = [](int i) { return Eigen::Vector3d(i & 1, (i >> 1) & 1, i >> 2); };
  SurfaceMesh mesh;
  const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : sides)
    addQuadrangle(mesh, {corner(side[0]), corner(side[1]), corner(side[2]), corner(side[3])});
  return mesh;
}

/// A ball of radius 1 in rings of quadrangles, each cut in two.
SurfaceMesh ball() {
  SurfaceMesh mesh;
  constexpr int rings = 60;
  constexpr int sides = 120;
  const auto at = [&](int ring, int side) {
    const double polar = std::numbers::pi * ring / rings;
    const double around = 2 * std::numbers::pi * side / sides;
    return Eigen::Vector3d(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                           std::cos(polar));
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side)
      addQuadrangle(
          mesh, {at(ring, side), at(ring + 1, side), at(ring + 1, side + 1), at(ring, side + 1)});
  return mesh;
}

TEST(OvercastSky, HasTheFortySixDirectionsByFives) {
  std::map<int, int> count; // by hundredths of a degree
  double weight = 0;
  for (const SkyDirection& each : overcastSky()) {
    ++count[static_cast<int>(std::lround(each.elevation / degree * 100))];
    EXPECT_NEAR(each.direction.norm(), 1, 1e-12);
    EXPECT_NEAR(each.direction.z(), std::sin(each.elevation), 1e-12);
    weight += each.weight;
  }
  const std::map<int, int> expected = {{923, 10}, {1081, 5}, {2657, 5}, {3108, 10},
                                       {4741, 5}, {5262, 5}, {6916, 5}, {9000, 1}};
  EXPECT_EQ(count, expected);
  EXPECT_NEAR(weight, 1, 1e-12);
}

// Light of an elevation goes by (1 + 2 s) s of its sine s, so the mean of s over the light is
// (1/3 + 2/4) / (1/2 + 2/3) = 5/7.
TEST(OvercastSky, WeighsByTheLightThatComesFromEachPart) {
  double mean = 0; // of the sine of the elevation
  std::map<int, double> perDirection;
  for (const SkyDirection& each : overcastSky()) {
    mean += each.weight * std::sin(each.elevation);
    perDirection[static_cast<int>(each.elevation / degree)] = each.weight;
  }
  EXPECT_NEAR(mean, 5.0 / 7, 0.01);
  EXPECT_LT(perDirection[9], perDirection[31]);
  EXPECT_LT(perDirection[31], perDirection[52]);
}

TEST(LightInterception, OfABallIsAQuarterFromEverywhere) {
  const LightInterception light = lightInterception(ball());
  EXPECT_NEAR(light.area, 4 * std::numbers::pi, 0.02);
  EXPECT_NEAR(light.star, 0.25, 0.001);
  ASSERT_EQ(light.directions.size(), 46U);
  for (const DirectionalStar& each : light.directions)
    EXPECT_NEAR(each.star, 0.25, 0.001);
}

// The silhouette of a cube of side 1 is |x| + |y| + |z| of the direction.
TEST(LightInterception, OfACubeIsTheSumOfTheDirection) {
  const LightInterception light = lightInterception(unitCube());
  EXPECT_DOUBLE_EQ(light.area, 6);
  for (std::size_t i = 0; i < light.directions.size(); ++i) {
    const double expected = overcastSky()[i].direction.cwiseAbs().sum();
    EXPECT_NEAR(light.directions[i].silhouette, expected, 0.005) << i;
  }
}

// From above the lower of two plates is hidden; from the side it is seen beside the upper one.
TEST(LightInterception, CountsWhatLiesBehindOnce) {
  SurfaceMesh mesh;
  addPlate(mesh, 2, 1, 0);
  addPlate(mesh, 2, 1, 5);
  const LightInterception light = lightInterception(mesh);
  const DirectionalStar& zenith = light.directions.back();
  EXPECT_NEAR(zenith.silhouette, 2, 0.01);
  EXPECT_NEAR(zenith.star, 0.5, 0.0025);
  const double low = std::sin(light.directions.front().elevation);
  EXPECT_NEAR(light.directions.front().silhouette, 4 * low, 0.02);
}

TEST(LightInterception, ComesNearerWithMorePixels) {
  const LightInterception light = lightInterception(ball(), {.pixels = 512});
  ASSERT_EQ(light.convergence.size(), 4U);
  EXPECT_EQ(light.convergence[0].pixels, 64);
  EXPECT_EQ(light.convergence[3].pixels, 512);
  EXPECT_EQ(light.convergence[3].star, light.star);
  EXPECT_NEAR(light.convergence[0].star, 0.25, 0.01);
  EXPECT_NEAR(light.convergence[3].star, 0.25, 0.001);
}

// Two hundred wires much thinner than a pixel, side by side: the mean is right all the same.
TEST(LightInterception, CountsThinWoodRightInTheMean) {
  SurfaceMesh mesh;
  for (int i = 0; i < 200; ++i)
    addPlate(mesh, 0.2, 200, 0, i * 1.0373);
  const LightInterception light = lightInterception(mesh, {.pixels = 128});
  EXPECT_NEAR(light.directions.back().star, 1, 0.15);
}

TEST(LightInterception, IsTheSameOnAnyNumberOfThreads) {
  const SurfaceMesh mesh = surfaceByGeneralizedCylinders(test::fork(5));
  const LightInterception many = lightInterception(mesh, {.pixels = 200});
  const ThreadLimit one(1);
  const LightInterception single = lightInterception(mesh, {.pixels = 200});
  EXPECT_EQ(single.star, many.star);
  for (std::size_t i = 0; i < many.directions.size(); ++i)
    EXPECT_EQ(single.directions[i].silhouette, many.directions[i].silhouette);
}

TEST(LightInterception, RefusesSurfacesThatAreNone) {
  EXPECT_THROW((void)lightInterception({}), Error);
  EXPECT_THROW((void)lightInterception(unitCube(), {.pixels = 1}), Error);
}

TEST(LightInterception, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)lightInterception(unitCube(), {}, Progress(source.get_token(), {})),
               Cancelled);
}

} // namespace
} // namespace espalier
