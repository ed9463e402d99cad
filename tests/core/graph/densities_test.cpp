#include "core/graph/densities.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace espalier {
namespace {

/// A square lattice of 41 x 41 points, `spacing` apart.
Eigen::Matrix3Xf sheet(float spacing) {
  Eigen::Matrix3Xf points(3, 41 * 41);
  for (int i = 0; i < 41; ++i)
    for (int j = 0; j < 41; ++j)
      points.col(41 * i + j) =
          spacing * Eigen::Vector3f(static_cast<float>(i), static_cast<float>(j), 0);
  return points;
}

constexpr std::size_t middle = 41 * 20 + 20;

std::vector<float> nearestOf(const Eigen::Matrix3Xf& points, int count) {
  return nearestDensities(SpatialIndex(points), count);
}

TEST(Densities, CountPointsPerArea) {
  // Of a lattice 0.1 apart, the 4 nearest lie 0.1 away, the 8 nearest up to 0.1 sqrt(2).
  EXPECT_NEAR(nearestOf(sheet(0.1F), 4)[middle], 400, 0.01);
  EXPECT_NEAR(nearestOf(sheet(0.1F), 8)[middle], 400, 0.01);
  // Links lead to the 4 nearest: 13 points lie within 2 steps along them.
  const NeighborhoodGraph graph(sheet(0.1F), 4);
  EXPECT_NEAR(radiusDensities(graph, 0.25F)[middle], 13 / 0.0625, 0.01);
}

TEST(Densities, FallByTheSquareOfTheUnit) {
  const NeighborhoodGraph meters(sheet(0.125F), 8);
  const NeighborhoodGraph halves(sheet(0.25F), 8);
  EXPECT_FLOAT_EQ(radiusDensities(meters, 0.5F)[middle], 4 * radiusDensities(halves, 1)[middle]);
  EXPECT_FLOAT_EQ(nearestOf(sheet(0.125F), 8)[middle], 4 * nearestOf(sheet(0.25F), 8)[middle]);
}

TEST(Densities, OfCoincidentPointsAreTheGreatestElsewhere) {
  Eigen::Matrix3Xf points(3, 5); // three at one place, two more
  points << 0, 0, 0, 1, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  const std::vector<float> densities = nearestOf(points, 2);
  EXPECT_FLOAT_EQ(densities[3], 2); // both are 1 away
  EXPECT_FLOAT_EQ(densities[0], 2);
  EXPECT_EQ(nearestOf(Eigen::Matrix3Xf::Ones(3, 4), 2), std::vector<float>(4, 0));
}

TEST(NormalizedDensities, RunFromZeroToOneWhateverTheExtremesAre) {
  std::vector<float> densities(1000);
  std::iota(densities.begin(), densities.end(), 0.0F);
  densities.back() = 1e9F; // one outlier
  const std::vector<float> normalized = normalizedDensities(densities, DensityMeasure::range);
  EXPECT_EQ(normalized.front(), 0);
  EXPECT_EQ(normalized.back(), 1);
  EXPECT_NEAR(normalized[500], 0.5, 0.01);
}

TEST(NormalizedDensities, ByRankAreTheShareOfThePointsThatLieThinner) {
  constexpr std::size_t count = 2001;
  std::vector<float> densities(count);
  for (std::size_t i = 0; i < count; ++i)
    densities[i] = std::exp(0.01F * static_cast<float>(i)); // few are dense, most thin
  EXPECT_LT(normalizedDensities(densities, DensityMeasure::range)[count / 2], 0.001F);
  const std::vector<float> ranks = normalizedDensities(densities, DensityMeasure::rank);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_NEAR(ranks[i], static_cast<float>(i) / (count - 1), 0.002) << i;
}

TEST(NormalizedDensities, OfAPartAreThoseItHasInTheWhole) {
  std::vector<float> densities(1000);
  std::iota(densities.begin(), densities.end(), 0.0F);
  const std::vector<float> part(densities.begin() + 700, densities.begin() + 800);
  for (const DensityMeasure measure : {DensityMeasure::range, DensityMeasure::rank}) {
    const std::vector<float> whole = normalizedDensities(densities, measure);
    EXPECT_EQ(normalizedDensities(part, levelsOf(densities, measure)),
              (std::vector<float>(whole.begin() + 700, whole.begin() + 800)));
  }
}

TEST(NormalizedDensities, AreAHalfWhereAllAreTheSame) {
  for (const DensityMeasure measure : {DensityMeasure::range, DensityMeasure::rank}) {
    EXPECT_EQ(normalizedDensities({3, 3, 3}, measure), (std::vector<float>{0.5F, 0.5F, 0.5F}));
    EXPECT_TRUE(normalizedDensities({}, measure).empty());
  }
  EXPECT_EQ(normalizedDensities({1, 2, 2, 2, 3}, DensityMeasure::rank)[2], 0.5F);
}

TEST(Densities, StopWhenAsked) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const NeighborhoodGraph graph(points, 7);
  using test::stopsWhenAsked;
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { (void)radiusDensities(graph, 1, p); }));
  EXPECT_TRUE(stopsWhenAsked(
      [&](const Progress& p) { (void)nearestDensities(SpatialIndex(points), 9, p); }));
}

} // namespace
} // namespace espalier
