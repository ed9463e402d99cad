#include "core/base/error.h"
#include "core/simulate/piece_tree.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/plants.h"
#include "tests/support/surface_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

TEST(SurfaceSampler, PutsEachPointOnTheEdgeItNames) {
  const Skeleton plant = growPlant({.segments = 60}, 3);
  const std::vector<EdgeSolid> wood = woodOf(plant);
  const SimulatedScan sample = sampleSurface(plant, {.points = 2000}, 1);
  ASSERT_EQ(sample.points.positions.size(), 2000U);
  ASSERT_EQ(sample.nodes.size(), 2000U);
  for (std::size_t i = 0; i < sample.nodes.size(); ++i) {
    const auto piece = std::find_if(wood.begin(), wood.end(), [&](const EdgeSolid& candidate) {
      return candidate.node == *sample.nodes[i];
    });
    ASSERT_NE(piece, wood.end());
    ASSERT_NEAR(signedDistance(*piece, sample.points.positions[i]), 0, 1e-9);
  }
}

TEST(SurfaceSampler, LeavesOutWhatLiesInOtherWood) {
  const Skeleton plant = growPlant({.segments = 60}, 3);
  const WoodIndex wood(woodOf(plant));
  for (const Vector3d& point : sampleSurface(plant, {.points = 2000}, 1).points.positions)
    ASSERT_GT(wood.distance(point, 1), -1e-8);
}

// The upper half of a cone from radius 2 to 0 has a quarter of its side.
TEST(SurfaceSampler, IsEvenByArea) {
  Skeleton cone = test::stick(2, 4);
  cone.setRadius(NodeId{0}, 2);
  cone.setRadius(NodeId{1}, 1e-9);
  const SimulatedScan sample = sampleSurface(cone, {.points = 20000}, 2);
  const auto upper = std::count_if(sample.points.positions.begin(), sample.points.positions.end(),
                                   [](const Vector3d& p) { return p.z() > 2; });
  EXPECT_NEAR(static_cast<double>(upper) / 20000, 0.25, 0.01);
}

TEST(SurfaceSampler, PutsAPointInEachSquareOfTheSpacing) {
  const SimulatedScan sample = sampleSurface(test::stick(11), {.spacing = 0.02}, 3);
  const double area = 2 * std::numbers::pi * 0.1 * 10; // the stick is 10 long and 0.1 thick
  EXPECT_NEAR(static_cast<double>(sample.nodes.size()), area / 4e-4, 100);
}

TEST(SurfaceSampler, ScattersPointsAcrossTheSurface) {
  const SimulatedScan sample =
      sampleSurface(test::stick(2, 1000), {.points = 20000, .noise = 0.01}, 4);
  double sum = 0;
  for (const Vector3d& point : sample.points.positions)
    sum += std::pow(point.head<2>().norm() - 0.1, 2);
  EXPECT_NEAR(std::sqrt(sum / 20000), 0.01, 0.0003);
}

TEST(SurfaceSampler, IsTheSameForTheSameSeed) {
  const Skeleton plant = test::fork(3);
  const auto places = [&](std::uint64_t seed) {
    return sampleSurface(plant, {.points = 50}, seed).points.positions;
  };
  EXPECT_EQ(places(1), places(1));
  EXPECT_NE(places(1), places(2));
}

TEST(SurfaceSampler, RefusesWhatItCannotSample) {
  const auto run = [](const Skeleton& plant, const SamplingOptions& options) {
    static_cast<void>(sampleSurface(plant, options, 1));
  };
  const Skeleton plant = test::stick(3);
  EXPECT_THROW(run(plant, {}), Error);
  EXPECT_THROW(run(plant, {.points = 5, .spacing = 1}), Error);
  EXPECT_THROW(run(plant, {.points = -5}), Error);
  EXPECT_THROW(run(plant, {.spacing = std::numeric_limits<double>::quiet_NaN()}), Error);
  EXPECT_THROW(run(plant, {.spacing = 1e-9}), Error);
  EXPECT_THROW(run(plant, {.points = 5, .noise = -1}), Error);
  EXPECT_THROW(run(test::stick(1), {.points = 5}), Error);
  EXPECT_THROW(run(test::stick(5, 0), {.points = 5}), Error); // all nodes at one place
}

TEST(SurfaceSampler, StopsWhenAskedTo) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(sampleSurface(test::stick(3), {.points = 9000}, 1,
                                               Progress(source.get_token(), {}))),
               Cancelled);
}

} // namespace
} // namespace espalier
