#include "core/base/error.h"
#include "core/evaluate/match/radius_agreement.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

constexpr double within = 0.05; // [L]
constexpr double sampleStep = 0.001;

/// A stick of 10 whose radius falls evenly from 2 to 1, then `change`d.
template <class Change> Skeleton tapered(const Change& change) {
  Skeleton plant = test::stick(11);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, change(2 - plant[id].position.z() / 10));
  return plant;
}
Skeleton tapered() {
  return tapered([](double radius) { return radius; });
}
constexpr double variance = 1.0 / 12; // of what is even between 1 and 2
constexpr double mean = 1.5;

TEST(RadiusAgreement, OfAPlantWithItselfIsWhole) {
  const RadiusAgreement same = radiusAgreement(tapered(), tapered(), within, sampleStep);
  EXPECT_NEAR(same.compared, 10, 1e-9);
  EXPECT_EQ(same.meanError, 0);
  EXPECT_EQ(same.rootMeanSquare, 0);
  EXPECT_DOUBLE_EQ(same.concordance, 1);
  EXPECT_EQ(radiusAgreement(test::stick(5), test::stick(5), within, sampleStep).concordance, 1)
      << "all alike";
}

// Lin: 2 cov / (var + var + (difference of means)^2).
TEST(RadiusAgreement, FallsWithAnErrorOfAllRadiiAlike) {
  const auto thicker = tapered([](double radius) { return radius + 0.5; });
  const RadiusAgreement added = radiusAgreement(thicker, tapered(), within, sampleStep);
  EXPECT_NEAR(added.meanError, 0.5, 1e-9);
  EXPECT_NEAR(added.rootMeanSquare, 0.5, 1e-9);
  EXPECT_NEAR(added.concordance, 2 * variance / (2 * variance + 0.25), 1e-6);
  const auto doubled = tapered([](double radius) { return 2 * radius; });
  const RadiusAgreement twice = radiusAgreement(doubled, tapered(), within, sampleStep);
  EXPECT_NEAR(twice.meanError, mean, 1e-6);
  EXPECT_NEAR(twice.rootMeanSquare, std::sqrt(variance + mean * mean), 1e-6);
  EXPECT_NEAR(twice.concordance, 4 * variance / (5 * variance + mean * mean), 1e-6);
}

TEST(RadiusAgreement, IsMinusOneOfTheContrary) {
  const auto contrary = tapered([](double radius) { return 3 - radius; });
  EXPECT_NEAR(radiusAgreement(contrary, tapered(), within, sampleStep).concordance, -1, 1e-9);
}

TEST(RadiusAgreement, ComparesOnlyWhatLiesNearAndHasARadius) {
  Skeleton twig = tapered();
  twig.add({.position = {4, 0, 5}, .radius = 9, .parent = NodeId{5}, .edge = EdgeType::branching});
  twig.setRadius(NodeId{10}, 0); // the last edge is not compared
  const RadiusAgreement found = radiusAgreement(twig, tapered(), within, sampleStep);
  EXPECT_NEAR(found.compared, 9 + within, 0.002) << "and the foot of the twig";
  Skeleton far = tapered();
  for (const NodeId id : far.ids())
    far.setPosition(id, far[id].position + Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(radiusAgreement(far, tapered(), within, sampleStep).compared, 0);
  EXPECT_THROW(static_cast<void>(radiusAgreement({}, tapered(), within, sampleStep)), Error);
}

// Of ten edges the one in the middle goes evenly from a tenth seen to nine tenths.
TEST(RadiusAgreement, IsGivenByTheArcThatWasSeen) {
  const auto sized = [](double radius) { return tapered([=](double) { return radius; }); };
  std::vector<double> coverages(11, 0.1);
  std::fill(coverages.begin() + 6, coverages.end(), 0.9);
  const RadiusAgreement found = radiusAgreement(sized(1), sized(2), within, sampleStep, coverages);
  ASSERT_EQ(found.byArc.size(), 4U);
  const double lengths[] = {5 + 0.15 / 0.8, 0.25 / 0.8, 0.25 / 0.8, 4 + 0.15 / 0.8};
  for (std::size_t k = 0; k < 4; ++k) {
    const RadiusByArc& arc = found.byArc[k];
    EXPECT_EQ(arc.from, 0.25 * static_cast<double>(k));
    EXPECT_EQ(arc.to, 0.25 * static_cast<double>(k + 1));
    EXPECT_NEAR(arc.compared, lengths[k], 0.002);
    EXPECT_NEAR(arc.meanError, -1, 1e-9);
    EXPECT_NEAR(arc.rootMeanSquare, 1, 1e-9);
    EXPECT_NEAR(arc.relativeRootMeanSquare, 0.5, 1e-9);
  }
  const RadiusAgreement whole =
      radiusAgreement(sized(1), sized(2), within, sampleStep, std::vector<double>(11, 1));
  EXPECT_EQ(whole.byArc[0].compared, 0);
  EXPECT_NEAR(whole.byArc[3].compared, 10, 1e-9) << "1 is in the last quarter";
  EXPECT_TRUE(radiusAgreement(sized(1), sized(2), within, sampleStep).byArc.empty());
}

TEST(RadiusAgreement, DoesNotDependOnNodesWithinEdges) {
  Skeleton denser = tapered();
  for (const NodeId id : denser.ids()) {
    const Node node = denser[id];
    if (!node.parent) continue;
    const Node& below = denser[*node.parent];
    denser.reparent(id,
                    denser.add({.position = (node.position + below.position) / 2,
                                .radius = (node.radius + below.radius) / 2,
                                .parent = node.parent}),
                    EdgeType::successor);
  }
  EXPECT_NEAR(radiusAgreement(denser, tapered(), within, sampleStep).rootMeanSquare, 0, 1e-9);
}

} // namespace
} // namespace espalier
