#include "core/radius/fused_radii.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::Each;
using testing::ElementsAre;

std::vector<MeasuredRadius> unmeasured(const Skeleton& plant) {
  return std::vector<MeasuredRadius>(plant.idEnd());
}

// One node: the mean of the logarithms by inverse variance.
TEST(FusedRadii, WeighByInverseVariance) {
  const Skeleton one = test::stick(1);
  const auto radiusAt = [&](double deviation) {
    return fusedRadii(one, {{.radius = 4, .deviation = deviation}}, {1}, {.modelSpread = 0.2})
        .radii[0];
  };
  EXPECT_NEAR(radiusAt(0.2), 2, 1e-9);
  EXPECT_NEAR(radiusAt(0.4), std::pow(4, 0.2), 1e-9); // weights 1 and 4
  EXPECT_NEAR(radiusAt(1e-6), 4, 1e-6);
}

TEST(FusedRadii, AreTheModelWhereNothingIsMeasured) {
  const Skeleton plant = test::fork(3);
  const FusedRadii result = fusedRadii(plant, unmeasured(plant), {5, 4, 1, 1, 1});
  EXPECT_THAT(result.radii, ElementsAre(5, 4, 1, 1, 1));
  EXPECT_THAT(result.shares, Each(0));
}

TEST(FusedRadii, CarryAMeasurementAlongItsAxisAndStateWhereTheyAreFrom) {
  const Skeleton stick = test::stick(60);
  std::vector<MeasuredRadius> measured = unmeasured(stick);
  measured[0] = {.radius = 2, .deviation = 0.01};
  const FusedRadii result = fusedRadii(stick, measured, std::vector<double>(60, 1));
  EXPECT_NEAR(result.radii[0], 2, 0.02);
  for (std::size_t i = 1; i < 60; ++i)
    EXPECT_LT(result.radii[i], result.radii[i - 1]);
  EXPECT_NEAR(result.radii[59], 1, 0.01);
  EXPECT_EQ(sourceOf(result.shares[0]), RadiusSource::measured);
  EXPECT_EQ(sourceOf(result.shares[59]), RadiusSource::extrapolated);
  EXPECT_TRUE(std::ranges::any_of(
      result.shares, [](double share) { return sourceOf(share) == RadiusSource::corrected; }));
}

// What the sum of squares asks for at two nodes on paper: weights 25 of the model (spread 0.2), 100
// of the measurement (0.1), tie 400 (0.05). With y = log r: 125 y0 + 400 (y0 - y1) = 100 log 2 and
// 25 y1 + 400 (y1 - y0) = 0.
TEST(FusedRadii, SolveTheSumOfSquares) {
  const Skeleton stick = test::stick(2);
  std::vector<MeasuredRadius> measured = unmeasured(stick);
  measured[0] = {.radius = 2, .deviation = 0.1};
  const FusedRadii result =
      fusedRadii(stick, measured, {1, 1}, {.modelSpread = 0.2, .axisStep = 0.05});
  const double y0 = 100 * std::log(2) / (525 - 400.0 * 400 / 425);
  EXPECT_NEAR(std::log(result.radii[0]), y0, 1e-9);
  EXPECT_NEAR(std::log(result.radii[1]), y0 * 400 / 425, 1e-9);
}

TEST(FusedRadii, NeverWidenTowardsTheTips) {
  const Skeleton plant = test::randomPlant(300, 4);
  std::vector<MeasuredRadius> measured = unmeasured(plant);
  std::vector<double> model(plant.idEnd(), 1);
  for (std::size_t i = 0; i < measured.size(); i += 3)
    measured[i] = {.radius = 0.5 + static_cast<double>(i % 7), .deviation = 0.1};
  const FusedRadii result = fusedRadii(plant, measured, model);
  for (const NodeId id : plant.ids()) {
    EXPECT_GT(result.radii[indexOf(id)], 0);
    if (const auto parent = plant[id].parent) {
      EXPECT_LE(result.radii[indexOf(id)], result.radii[indexOf(*parent)]);
    }
  }
}

TEST(FusedRadii, ScaleWithTheUnit) {
  const Skeleton stick = test::stick(5);
  std::vector<MeasuredRadius> measured = unmeasured(stick);
  measured[2] = {.radius = 3, .deviation = 0.1};
  const auto meters = fusedRadii(stick, measured, {4, 3, 2, 2, 1}).radii;
  measured[2].radius *= 1000;
  const auto millimeters = fusedRadii(stick, measured, {4000, 3000, 2000, 2000, 1000}).radii;
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(millimeters[i], 1000 * meters[i], 1e-6);
}

TEST(FusedRadii, OfNothingAreNone) {
  EXPECT_TRUE(fusedRadii({}, {}, {}).radii.empty());
}

TEST(LimitedRadii, PassOnFromTheRootAndHoldBranches) {
  const Skeleton fork = test::fork(2);
  EXPECT_THAT(limitedRadii(fork, {2, 3, 4, 4}), ElementsAre(2, 2, 2, 2));
  EXPECT_THAT(limitedRadii(fork, {2, 3, 4, 4}, 0.5), ElementsAre(2, 2, 2, 1));
  EXPECT_THAT(limitedRadii(fork, {4, 3, 1, 2}), ElementsAre(4, 3, 1, 2));
}

} // namespace
} // namespace espalier
