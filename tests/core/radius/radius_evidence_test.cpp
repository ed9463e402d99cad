#include "core/radius/radius_evidence.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

/// Bounds that no feature moves.
RadiusRegression always(const RadiusQuantiles& quantiles) {
  RadiusRegression regression;
  regression.low.constant = quantiles.low;
  regression.middle.constant = quantiles.middle;
  regression.high.constant = quantiles.high;
  return regression;
}

std::vector<RadiusEvidence> evidenceOf(const Skeleton& plant, double radius, double share = 1) {
  return std::vector<RadiusEvidence>(plant.idEnd(),
                                     {.radius = radius, .model = radius, .share = share});
}

TEST(RadiusEvidence, CorrectsThinRadiiThatAreUncertain) {
  const Skeleton stick = test::stick(3);
  const auto known = knownRadii(stick, evidenceOf(stick, 1), 0.01, always({-1, -0.5, 0}));
  for (const KnownRadius& each : known) {
    EXPECT_NEAR(each.radius, 0.01 * std::exp(-0.5), 1e-12);
    EXPECT_NEAR(each.origin.least, std::exp(-0.5), 1e-6);
    EXPECT_NEAR(each.origin.most, std::exp(0.5), 1e-6);
    EXPECT_EQ(each.origin.source, RadiusSource::corrected) << "though it was measured";
  }
}

TEST(RadiusEvidence, LeavesThickAndCertainRadiiAsTheyAre) {
  const Skeleton stick = test::stick(3);
  const auto thick = knownRadii(stick, evidenceOf(stick, 4), 0.01, always({-1, -0.5, 0}));
  EXPECT_DOUBLE_EQ(thick[1].radius, 0.04);
  EXPECT_NEAR(thick[1].origin.least, std::exp(-1), 1e-6);
  EXPECT_EQ(thick[1].origin.most, 1);
  EXPECT_EQ(thick[1].origin.source, RadiusSource::measured);
  const auto certain = knownRadii(stick, evidenceOf(stick, 1), 0.01, always({-0.3, -0.1, 0.1}));
  EXPECT_DOUBLE_EQ(certain[1].radius, 0.01);
  const auto modeled = knownRadii(stick, evidenceOf(stick, 1, 0), 0.01, always({-0.3, 0, 0.1}));
  EXPECT_EQ(modeled[1].origin.source, RadiusSource::extrapolated);
}

TEST(RadiusEvidence, SmoothsAlongTheAxisAlone) {
  Skeleton plant = test::stick(3);
  const NodeId twig = plant.add(
      {.position = {1, 0, 1}, .radius = 0.1, .parent = NodeId{1}, .edge = EdgeType::branching});
  RadiusRegression regression = always({-1, 0, 0});
  regression.high.weights[10] = 1; // logarithm of points + 1
  regression.high.most[10] = 10;
  std::vector<RadiusEvidence> evidence = evidenceOf(plant, 4);
  evidence[1].points = std::exp(1.0) - 1;
  evidence[indexOf(twig)].points = std::exp(2.0) - 1;
  const auto known = knownRadii(plant, evidence, 1, regression);
  EXPECT_NEAR(std::log(known[0].origin.most), 1.0 / 3, 1e-6);
  EXPECT_NEAR(std::log(known[1].origin.most), 1.0 / 2, 1e-6);
  EXPECT_NEAR(std::log(known[2].origin.most), 1.0 / 3, 1e-6);
  EXPECT_NEAR(std::log(known[indexOf(twig)].origin.most), 2, 1e-6);
}

// Without points, without a pipe model, without anything but itself.
TEST(RadiusEvidence, IsANumberWhateverIsMissing) {
  const Skeleton stick = test::stick(1);
  const auto known = knownRadii(stick, {{.radius = 0.01, .model = 0.5}}, 0.001);
  EXPECT_GT(known[0].radius, 0);
  EXPECT_LE(known[0].origin.least, 1);
  EXPECT_GE(known[0].origin.most, 1);
  EXPECT_TRUE(known[0].origin.isSound());
}

} // namespace
} // namespace espalier
