#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/simulate/foliage.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/piece_tree.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;
using test::idealScanner;

constexpr double pi = std::numbers::pi;

const Skeleton& pine() {
  static const Skeleton plant =
      growPlant({.architecture = Architecture::conifer, .segments = 60}, 2);
  return plant;
}

/// Needles of one length, all along a stick of length 1 and radius 0.1.
Foliage needles() {
  return {.blades = {.spacing = 0.001, .length = 0.02, .width = 0.001, .angle = 0.5, .reach = 1}};
}

TEST(Foliage, IsAsManyOrgansAsTheLengthOfTheWoodAsksFor) {
  const Organs organs = organsOf(test::stick(11, 0.1), needles(), 1, 1);
  const double expected = 1 / needles().blades.spacing;
  EXPECT_NEAR(static_cast<double>(organs.blades.size()), expected, 4 * std::sqrt(expected));
  EXPECT_TRUE(organs.shortShoots.empty());
}

TEST(Foliage, StandsOnTheWoodAtItsAngleAndIsAsLongAsAsked) {
  const Organs organs = organsOf(test::stick(11, 0.1), needles(), 1, 2);
  double angles = 0;
  double lengths = 0;
  for (const Blade& blade : organs.blades) {
    EXPECT_NEAR(blade.base.head<2>().norm(), 0.1, 1e-12);
    EXPECT_GT(blade.along.head<2>().dot(blade.base.head<2>()), -1e-12) << "outwards";
    EXPECT_NEAR(blade.half.dot(blade.along), 0, 1e-12);
    EXPECT_NEAR(blade.half.norm(), 0.0005, 1e-12);
    angles += std::acos(blade.along.normalized().z());
    lengths += blade.along.norm();
  }
  const auto count = static_cast<double>(organs.blades.size());
  EXPECT_NEAR(angles / count, 0.5, 4 * 0.15 / std::sqrt(count));
  EXPECT_NEAR(lengths / count, 0.02, 0.0005);
}

TEST(Foliage, StandsNearApicesOnly) {
  Foliage foliage = needles();
  foliage.blades.reach = 0.2;
  for (const Blade& blade : organsOf(test::stick(11, 0.1), foliage, 1, 3).blades)
    EXPECT_GE(blade.base.z(), 0.8);
}

TEST(Foliage, OfShortShootsIsBorneByThemToo) {
  Foliage foliage{.shortShoots = {.spacing = 0.05, .length = 0.1, .angle = pi / 2, .reach = 1},
                  .blades = {.spacing = 0.002, .length = 0.01, .width = 0.001, .reach = 1}};
  const Organs organs = organsOf(test::stick(11, 0.1), foliage, 1, 4);
  ASSERT_GT(organs.shortShoots.size(), 8U);
  for (const EdgeSolid& shoot : organs.shortShoots) {
    EXPECT_FALSE(shoot.node);
    EXPECT_NEAR((shoot.to - shoot.from).norm() - 0.1, 0.1, 0.03 + 1e-12) << "beyond the wood";
  }
  const auto onShoots =
      std::count_if(organs.blades.begin(), organs.blades.end(),
                    [](const Blade& blade) { return blade.base.head<2>().norm() > 0.15; });
  EXPECT_GT(onShoots, 50);
}

TEST(Foliage, ScalesWithThePlant) {
  Skeleton large = pine();
  for (const NodeId id : large.ids()) { // by a power of two: no rounding
    large.setPosition(id, 1024 * large[id].position);
    large.setRadius(id, 1024 * large[id].radius);
  }
  const Foliage foliage = foliageOf(Architecture::conifer);
  const Organs a = organsOf(pine(), foliage, 4, 5);
  const Organs b = organsOf(large, foliage, 4096, 5);
  ASSERT_EQ(a.blades.size(), b.blades.size());
  for (std::size_t i = 0; i < a.blades.size(); ++i)
    ASSERT_NEAR((1024 * a.blades[i].along - b.blades[i].along).norm(), 0, 1e-9);
}

TEST(Foliage, OfEachKindOfPlantIsThereAndGrowsWithTheDensity) {
  for (const Architecture kind :
       {Architecture::broadleaf, Architecture::conifer, Architecture::shrub, Architecture::herb}) {
    const auto count = [&](double density) {
      const Organs organs = organsOf(pine(), foliageOf(kind, density), 4, 6);
      return static_cast<double>(organs.blades.size() + organs.shortShoots.size());
    };
    EXPECT_EQ(count(0), 0);
    EXPECT_GT(count(1), 50);
    EXPECT_GT(count(4) / count(2), 1.7);
    EXPECT_LT(count(4) / count(2), 4); // of blades on short shoots alone it would be 4
  }
}

TEST(Foliage, OfOptionsOutOfRangeIsRefused) {
  const auto grow = [](const OrganHabit& blades) {
    static_cast<void>(organsOf(test::stick(3), {.blades = blades}, 1, 1));
  };
  EXPECT_THROW(grow({.spacing = -1}), Error);
  EXPECT_THROW(grow({.spacing = std::nan("")}), Error);
  EXPECT_THROW(grow({.spacing = 0.1, .length = 0}), Error);
  EXPECT_THROW(grow({.spacing = 0.1, .width = 2}), Error);
  EXPECT_THROW(grow({.spacing = 0.1, .angle = 4}), Error);
  EXPECT_THROW(grow({.spacing = 0.1, .reach = -1}), Error);
  EXPECT_THROW(grow({.spacing = 1e-9}), Error);
}

TEST(Foliage, OnPetiolesStandsAwayFromTheWood) {
  Foliage foliage{.blades = {.spacing = 0.05, .length = 0.02, .width = 0.01, .reach = 1}};
  foliage.petiole = 2;
  const Organs organs = organsOf(test::stick(11, 0.1), foliage, 1, 8);
  ASSERT_FALSE(organs.blades.empty());
  ASSERT_EQ(organs.petioles.size(), organs.blades.size());
  for (std::size_t i = 0; i < organs.blades.size(); ++i) {
    EXPECT_EQ(organs.blades[i].base, organs.petioles[i].to);
    EXPECT_NEAR(organs.petioles[i].length(), 2 * organs.blades[i].along.norm(), 1e-12);
    EXPECT_EQ(organs.petioles[i].organ, Organ::petiole);
    EXPECT_FALSE(organs.petioles[i].node);
  }
}

TEST(Foliage, OfCompoundLeavesHasPairsOfLeafletsAlongThePetiole) {
  Foliage foliage{.blades = {.spacing = 0.2, .length = 0.02, .width = 0.01, .reach = 1}};
  foliage.petiole = 3;
  foliage.leaflets = 2;
  const Organs organs = organsOf(test::stick(11, 0.1), foliage, 1, 8);
  ASSERT_FALSE(organs.petioles.empty());
  ASSERT_EQ(organs.blades.size(), 5 * organs.petioles.size());
  for (std::size_t i = 0; i < organs.blades.size(); ++i) {
    const EdgeSolid& stalk = organs.petioles[i / 5];
    const double along =
        (organs.blades[i].base - stalk.from).dot((stalk.to - stalk.from).normalized());
    const std::size_t pair = i % 5 / 2 + 1; // of 3 places along it, the last at its end
    EXPECT_NEAR(along / stalk.length(), static_cast<double>(pair) / 3, 1e-9);
  }
}

TEST(Foliage, ThatDroopsBendsToTheGroundInPiecesThatMeet) {
  Foliage foliage{.blades = {.spacing = 0.5, .length = 0.5, .width = 0.02, .reach = 1}};
  foliage.droop = 1.5;
  const Organs organs = organsOf(test::stick(11, 0.1), foliage, 1, 9);
  ASSERT_FALSE(organs.blades.empty());
  int bent = 0;
  for (std::size_t i = 1; i < organs.blades.size(); ++i) {
    const Blade& before = organs.blades[i - 1];
    if (before.atTip == 0) continue; // the last of a leaf
    EXPECT_LT((before.base + before.along - organs.blades[i].base).norm(), 1e-12);
    EXPECT_LT(organs.blades[i].along.normalized().z(), before.along.normalized().z() + 1e-12);
    ++bent;
  }
  EXPECT_GE(bent, 7);
}

TEST(Foliage, OfLeavesOutOfRangeIsRefused) {
  const auto grow = [](double petiole, int leaflets, double droop) {
    Foliage foliage{.blades = {.spacing = 0.1}};
    foliage.petiole = petiole;
    foliage.leaflets = leaflets;
    foliage.droop = droop;
    static_cast<void>(organsOf(test::stick(3), foliage, 1, 1));
  };
  EXPECT_NO_THROW(grow(1, 2, 1));
  EXPECT_THROW(grow(-1, 0, 0), Error);
  EXPECT_THROW(grow(std::nan(""), 0, 0), Error);
  EXPECT_THROW(grow(1, -1, 0), Error);
  EXPECT_THROW(grow(1, 101, 0), Error);
  EXPECT_THROW(grow(1, 0, 5), Error);
}

// A strip 2 long and 1 wide.
TEST(Blade, MayBeAsWideAtItsEndsAsAtItsMiddle) {
  const Blade strip{
      .base = {0, 0, 0}, .along = {2, 0, 0}, .half = {0, 0.5, 0}, .atBase = 1, .atTip = 1};
  EXPECT_TRUE(hit(strip, {{0.05, 0.4, 3}, -Vector3d::UnitZ()}));
  EXPECT_TRUE(hit(strip, {{1.95, -0.4, 3}, -Vector3d::UnitZ()}));
  EXPECT_FALSE(hit(strip, {{1, 0.6, 3}, -Vector3d::UnitZ()}));
  EXPECT_FALSE(hit(strip, {{-0.01, 0, 3}, -Vector3d::UnitZ()}));
  EXPECT_FALSE(hit(strip, {{2.01, 0, 3}, -Vector3d::UnitZ()}));
  EXPECT_TRUE(boundsOf(strip).contains(Vector3d(0, 0.5, 0)));
  EXPECT_TRUE(boundsOf(strip).contains(Vector3d(2, -0.5, 0)));
}

// A lozenge in the plane z = 0, 2 long and 1 wide.
TEST(Blade, IsHitFromBothSidesWhereItIs) {
  const Blade blade{.base = {0, 0, 0}, .along = {2, 0, 0}, .half = {0, 0.5, 0}};
  const auto fromAbove = hit(blade, {{1, 0.4, 3}, -Vector3d::UnitZ()});
  ASSERT_TRUE(fromAbove);
  EXPECT_DOUBLE_EQ(fromAbove->range, 3);
  EXPECT_EQ(fromAbove->normal, Vector3d::UnitZ());
  EXPECT_FALSE(fromAbove->node);
  const auto fromBelow = hit(blade, {{1, 0.4, -3}, Vector3d::UnitZ()});
  ASSERT_TRUE(fromBelow);
  EXPECT_EQ(fromBelow->normal, -Vector3d::UnitZ());
  EXPECT_FALSE(hit(blade, {{0.2, 0.4, 3}, -Vector3d::UnitZ()})) << "it is narrow at its base";
  EXPECT_FALSE(hit(blade, {{2.1, 0, 3}, -Vector3d::UnitZ()})) << "beyond its tip";
  EXPECT_FALSE(hit(blade, {{1, 0, 3}, Vector3d::UnitZ()})) << "behind";
  EXPECT_FALSE(hit(blade, {{-1, 0, 0}, Vector3d::UnitX()})) << "on edge";
}

/// Distance [L] from each point of no edge to the surface of the wood.
std::vector<double> offWood(const SimulatedScan& scan, const Skeleton& plant) {
  const WoodIndex wood(woodOf(plant));
  std::vector<double> distances;
  for (std::size_t i = 0; i < scan.nodes.size(); ++i)
    if (!scan.nodes[i])
      distances.push_back(
          wood.distance(scan.points.positions[i], std::numeric_limits<double>::infinity()));
  return distances;
}

TEST(LaserScanner, SeesFoliageAroundTheWoodThatBearsIt) {
  ScannerOptions options = idealScanner(10'000);
  options.foliage = foliageOf(Architecture::conifer);
  const SimulatedScan result = scan(pine(), options, 1);
  const std::vector<double> distances = offWood(result, pine());
  const double share =
      static_cast<double>(distances.size()) / static_cast<double>(result.nodes.size());
  EXPECT_GT(share, 0.05);
  EXPECT_LT(share, 0.7);
  const double extent = 4; // and somewhat over it: 1.3 needles on a short shoot of 1.3 lengths
  EXPECT_LT(*std::max_element(distances.begin(), distances.end()), 1.3 * 0.016 * 1.1 * extent);
  EXPECT_GT(*std::max_element(distances.begin(), distances.end()), 0.5 * 0.011 * extent);
}

TEST(LaserScanner, SaysWhatEachPointLiesOn) {
  ScannerOptions options = idealScanner(10'000);
  options.foliage = foliageOf(Architecture::conifer);
  options.foliage.shortShoots.spacing = 0;
  const SimulatedScan result = scan(pine(), options, 1);
  ASSERT_EQ(result.organs.size(), result.points.positions.size());
  for (std::size_t i = 0; i < result.organs.size(); ++i)
    EXPECT_EQ(result.organs[i], result.nodes[i] ? Organ::wood : Organ::needle);
}

TEST(LaserScanner, SeesNoFoliageUnlessAskedTo) {
  EXPECT_TRUE(offWood(scan(pine(), idealScanner(3000), 1), pine()).empty());
}

TEST(LaserScanner, SeesTheSameFoliageOnAnyNumberOfThreads) {
  const auto scanned = [&](int threads) {
    const ThreadLimit limit(threads);
    ScannerOptions options{.points = 3000, .clumps = 2};
    options.foliage = foliageOf(Architecture::conifer);
    return scan(pine(), options, 7);
  };
  const SimulatedScan one = scanned(1);
  const SimulatedScan two = scanned(2);
  EXPECT_EQ(one.points.positions, two.points.positions);
  EXPECT_EQ(one.nodes, two.nodes);
}

} // namespace
} // namespace espalier
