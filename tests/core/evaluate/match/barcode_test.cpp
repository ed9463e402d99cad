#include "core/evaluate/match/barcode.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

TEST(Barcode, OfAStickIsOneBarAlongIt) {
  EXPECT_THAT(barcode(test::stick(5)), ElementsAre(Bar{0, 4}));
  EXPECT_THAT(barcode(test::stick(1)), ElementsAre());
  EXPECT_THAT(barcode({}), ElementsAre());
}

// A trunk of 4 with a twig of 1 at 1 and one of 5 at 2: the longer path up goes on.
TEST(Barcode, EndsWhatIsShorterWhereItLeaves) {
  Skeleton plant = test::stick(5);
  plant.add({.position = {1, 0, 1}, .parent = NodeId{1}, .edge = EdgeType::branching});
  plant.add({.position = {5, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  EXPECT_THAT(barcode(plant), UnorderedElementsAre(Bar{1, 2}, Bar{2, 4}, Bar{0, 7}));
}

TEST(Barcode, OfSeveralTreesHasTheBarsOfEach) {
  Skeleton trees = test::stick(3);
  const NodeId other = trees.add({.position = {9, 0, 0}});
  trees.add({.position = {9, 0, 5}, .parent = other});
  EXPECT_THAT(barcode(trees), UnorderedElementsAre(Bar{0, 2}, Bar{0, 5}));
}

TEST(BarcodeDistance, IsNoneOfAPlantWhereverItLiesAndHoweverItsNodesLie) {
  const Skeleton bush = test::bush();
  const std::vector<Bar> bars = barcode(bush);
  EXPECT_EQ(barcodeDistance(bars, bars), 0);
  const Eigen::Isometry3d motion = test::motion(0.7, {3, 4, 5});
  const Skeleton moved =
      test::placed(bush, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return motion * p; });
  EXPECT_NEAR(barcodeDistance(bars, barcode(moved)), 0, 1e-9);
  EXPECT_NEAR(barcodeDistance(bars, barcode(test::withMiddleNodes(bush))), 0, 1e-9);
  EXPECT_EQ(barcodeDistance({}, {}), 0);
}

// Forks of two and three shoots: of 2 + 3 bars one has no partner.
TEST(BarcodeDistance, CountsABarWithoutAPartner) {
  const std::vector<Bar> two = barcode(test::fork(2));
  const std::vector<Bar> three = barcode(test::fork(3));
  EXPECT_NEAR(barcodeDistance(two, three), 1.0 / 5, 1e-9);
  EXPECT_NEAR(barcodeDistance(three, two), 1.0 / 5, 1e-9);
  EXPECT_NEAR(barcodeDistance(two, {}), 1, 1e-12);
}

// Of two Gaussians of deviation s whose middles are d apart, erf(d / (2 sqrt(2) s)) differs.
TEST(BarcodeDistance, GrowsAsTwoSpotsGoApart) {
  for (const double apart : {0.02, 0.05, 0.1, 0.2})
    EXPECT_NEAR(barcodeDistance({{0, 1}}, {{0, 1 - apart}}),
                std::erf(apart / (2 * std::sqrt(2.0) * 0.05)), 0.005)
        << apart;
  EXPECT_NEAR(barcodeDistance({{0, 100}}, {{0, 50}}), 1, 1e-4);
}

TEST(BarcodeDistance, IsTheSameInMetersAndMillimeters) {
  const Skeleton bush = test::bush();
  const Skeleton other = test::jittered(bush, 0.2);
  const double inMeters = barcodeDistance(barcode(bush), barcode(other));
  EXPECT_GT(inMeters, 0);
  EXPECT_NEAR(
      barcodeDistance(barcode(test::scaled(bush, 1000)), barcode(test::scaled(other, 1000))),
      inMeters, 1e-9);
}

} // namespace
} // namespace espalier
