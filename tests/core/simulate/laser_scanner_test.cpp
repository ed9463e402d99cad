#include "core/base/error.h"
#include "core/base/parallel.h"
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

Skeleton smallTree() {
  return growPlant({.segments = 120}, 5);
}

double offSurface(const WoodIndex& wood, const Vector3d& place) {
  return std::abs(wood.distance(place, std::numeric_limits<double>::infinity()));
}

Eigen::Index pointsOf(const SimulatedScan& scan, NodeId node) {
  return std::count(scan.nodes.begin(), scan.nodes.end(), std::optional(node));
}

TEST(LaserScanner, PutsPointsOnTheSurfaceIfItMakesNoErrors) {
  const Skeleton plant = smallTree();
  const WoodIndex wood(woodOf(plant));
  const SimulatedScan result = scan(plant, idealScanner(3000), 1);
  for (std::size_t i = 0; i < result.nodes.size(); ++i) {
    ASSERT_TRUE(result.nodes[i]);
    ASSERT_NEAR(offSurface(wood, result.points.positions[i]), 0, 1e-9);
  }
}

TEST(LaserScanner, KnowsWhichEdgeEachPointLiesOn) {
  const Skeleton plant = smallTree();
  const SimulatedScan result = scan(plant, idealScanner(2000), 2);
  const std::vector<EdgeSolid> wood = woodOf(plant);
  for (std::size_t i = 0; i < result.nodes.size(); ++i) {
    const auto piece = std::find_if(wood.begin(), wood.end(), [&](const EdgeSolid& candidate) {
      return candidate.node == *result.nodes[i];
    });
    ASSERT_NE(piece, wood.end());
    ASSERT_NEAR(signedDistance(*piece, result.points.positions[i]), 0, 1e-9);
  }
}

// A wide wall, so that a beam is compared with the very place it met.
TEST(LaserScanner, ScattersPointsAlongTheBeamByTheRangeNoise) {
  ScannerOptions options = idealScanner(4000);
  options.rangeNoise = 0.01;
  options.stations = 1;
  options.azimuth = 0;
  Skeleton wall = test::stick(2);
  wall.setRadius(NodeId{0}, 40); // next to flat where it is met
  wall.setRadius(NodeId{1}, 40);
  options.at = {{41, 0, 0.5}};
  const SimulatedScan result = scan(wall, options, 3);
  const WoodIndex wood(woodOf(wall));
  double sum = 0;
  double count = 0;
  for (const Vector3d& point : result.points.positions) {
    const Vector3d beam = (point - options.at.front()).normalized();
    const auto truth = wood.firstHit({options.at.front(), beam});
    if (!truth) continue;
    const double error = (point - options.at.front()).norm() - truth->range;
    sum += error * error;
    ++count;
  }
  EXPECT_GT(count, 3000);
  EXPECT_NEAR(std::sqrt(sum / count), 0.01, 0.0005);
}

// A trunk at the origin and a twig of the same plant behind it.
Skeleton twigBehindTrunk() {
  Skeleton plant;
  const NodeId foot = plant.add({.position = {0, 0, 0}, .radius = 0.2});
  plant.add({.position = {0, 0, 3}, .radius = 0.2, .parent = foot});
  const NodeId knee = plant.add(
      {.position = {-0.5, 0, 0}, .radius = 0.01, .parent = foot, .edge = EdgeType::branching});
  plant.add({.position = {-0.5, 0, 2}, .radius = 0.01, .parent = knee});
  return plant;
}

TEST(LaserScanner, SeesNoTwigBehindATrunk) {
  const Skeleton plant = twigBehindTrunk();
  constexpr NodeId twig{3};
  ScannerOptions options = idealScanner(5000);
  options.at = {{6, 0, 1}};
  EXPECT_EQ(pointsOf(scan(plant, options, 1), twig), 0);
  options.at = {{-6, 0, 1}};
  EXPECT_GT(pointsOf(scan(plant, options, 1), twig), 50);
}

TEST(LaserScanner, SeesOneSideOnlyFromOneStation) {
  ScannerOptions options = idealScanner(3000);
  options.stations = 1;
  options.azimuth = 0;
  const SimulatedScan result = scan(test::stick(4), options, 1);
  ASSERT_EQ(result.stations.size(), 1U);
  EXPECT_GT(result.stations[0].x(), 0);
  const auto behind = std::count_if(result.points.positions.begin(), result.points.positions.end(),
                                    [](const Vector3d& p) { return p.x() < -0.01 && p.z() < 3; });
  EXPECT_EQ(behind, 0);
}

// A stick about the z axis: each station sees the side that is turned to it, and of the ends more.
TEST(LaserScanner, KnowsFromWhichStationEachPointIs) {
  ScannerOptions options = idealScanner(2000);
  options.at = {Vector3d(10, 0, 1), Vector3d(-10, 0, 1)};
  const SimulatedScan result = scan(test::stick(4), options, 1);
  const std::vector<RawPoints> stations = pointsByStation(result);
  ASSERT_EQ(stations.size(), 2U);
  EXPECT_EQ(stations[0].positions.size() + stations[1].positions.size(), result.nodes.size());
  for (const double side : {1.0, -1.0}) {
    const RawPoints& its = stations[side > 0 ? 0 : 1];
    EXPECT_EQ(its.stations[0].scanner, Vector3d(10 * side, 0, 1));
    EXPECT_EQ(its.intensities.size(), its.positions.size());
    EXPECT_GT(its.positions.size(), 500U);
    for (const Vector3d& position : its.positions)
      EXPECT_TRUE(position.z() <= 0 || position.z() >= 3 || side * position.x() > -0.01);
  }
}

TEST(LaserScanner, ReturnsAboutAsManyPointsAsAskedFor) {
  const Skeleton plant = smallTree();
  for (const Eigen::Index asked : {500, 20000}) {
    const auto found = static_cast<double>(scan(plant, {.points = asked}, 4).nodes.size());
    EXPECT_NEAR(found / static_cast<double>(asked), 1, 0.1);
  }
}

TEST(LaserScanner, StandsWhereItIsAskedTo) {
  const Skeleton plant = test::stick(11);
  const SimulatedScan result =
      scan(plant, {.points = 200, .stations = 3, .distance = 2, .elevation = 0.5}, 1);
  ASSERT_EQ(result.stations.size(), 3U);
  const Eigen::AlignedBox3d bounds = WoodIndex(woodOf(plant)).bounds();
  for (const Vector3d& station : result.stations) {
    EXPECT_NEAR(station.head<2>().norm(), 2 * bounds.sizes().z(), 1e-9);
    EXPECT_NEAR(station.z(), bounds.center().z(), 1e-9);
  }
}

// Of two equal sticks the one at a third of the range has nine times the points for a given area.
TEST(LaserScanner, HasMorePointsWhereItIsNear) {
  Skeleton plant;
  for (const double x : {0.0, 4.0}) {
    const NodeId foot = plant.add({.position = {x, 0, 0}, .radius = 0.05});
    plant.add({.position = {x, 0, 0.5}, .radius = 0.05, .parent = foot});
  }
  ScannerOptions options = idealScanner(20000);
  options.at = {{6, 0.5, 0.25}};
  const SimulatedScan result = scan(plant, options, 1);
  const double ratio = static_cast<double>(pointsOf(result, NodeId{3})) /
                       static_cast<double>(pointsOf(result, NodeId{1}));
  EXPECT_NEAR(ratio, 36.25 / 4.25, 0.8);
}

TEST(LaserScanner, IsTheSameForAnyNumberOfThreads) {
  const Skeleton plant = smallTree();
  const auto scanned = [&](int threads, std::uint64_t seed) {
    const ThreadLimit limit(threads);
    return scan(plant, {.points = 3000, .stations = 2, .clumps = 3}, seed);
  };
  const SimulatedScan one = scanned(1, 9);
  const SimulatedScan two = scanned(2, 9);
  EXPECT_EQ(one.points.positions, two.points.positions);
  EXPECT_EQ(one.points.intensities, two.points.intensities);
  EXPECT_EQ(one.nodes, two.nodes);
  EXPECT_NE(one.points.positions, scanned(2, 10).points.positions);
}

TEST(LaserScanner, ScalesWithThePlant) {
  const Skeleton small = smallTree();
  Skeleton large = small;
  for (const NodeId id : large.ids()) { // by a power of two: no rounding
    large.setPosition(id, 1024 * large[id].position);
    large.setRadius(id, 1024 * large[id].radius);
  }
  const SimulatedScan a = scan(small, {.points = 3000}, 5);
  const SimulatedScan b = scan(large, {.points = 3000}, 5);
  ASSERT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.points.intensities, b.points.intensities);
  for (std::size_t i = 0; i < a.nodes.size(); ++i)
    ASSERT_NEAR((1024 * a.points.positions[i] - b.points.positions[i]).norm(), 0, 1e-9);
}

TEST(LaserScanner, AddsStrayPointsInTheShareAskedFor) {
  ScannerOptions options = idealScanner(5000);
  options.strayShare = 0.2;
  const Skeleton plant = smallTree();
  const SimulatedScan result = scan(plant, options, 6);
  const auto strays = std::count(result.nodes.begin(), result.nodes.end(), std::nullopt);
  EXPECT_NEAR(static_cast<double>(strays) / static_cast<double>(result.nodes.size()), 0.2, 1e-3);
  EXPECT_NEAR(static_cast<double>(result.nodes.size()), 5000, 500);
}

TEST(LaserScanner, MixesTheRangesAtEdgesIfItsBeamIsWide) {
  const Skeleton plant = smallTree();
  const WoodIndex wood(woodOf(plant));
  ScannerOptions options = idealScanner(5000);
  options.beamWidth = 1;
  const SimulatedScan result = scan(plant, options, 7);
  const auto off = std::count_if(result.points.positions.begin(), result.points.positions.end(),
                                 [&](const Vector3d& p) { return offSurface(wood, p) > 0.004; });
  EXPECT_GT(off, 20);
  EXPECT_LT(off, 0.3 * static_cast<double>(result.nodes.size()));
}

TEST(LaserScanner, PutsTheScanOfEachStationOutOfPlaceAsAWhole) {
  ScannerOptions options = idealScanner(1000);
  options.stations = 3;
  const Skeleton plant = smallTree();
  const SimulatedScan exact = scan(plant, options, 8);
  options.misalignment = 0.05;
  const SimulatedScan shifted = scan(plant, options, 8);
  ASSERT_EQ(exact.nodes, shifted.nodes);
  std::vector<Vector3d> shifts;
  for (std::size_t i = 0; i < exact.nodes.size(); ++i) {
    const Vector3d shift = shifted.points.positions[i] - exact.points.positions[i];
    if (shifts.empty() || (shift - shifts.back()).norm() > 1e-9) shifts.push_back(shift);
  }
  ASSERT_EQ(shifts.size(), 3U);
  for (const Vector3d& shift : shifts)
    EXPECT_LT(shift.norm(), 0.3);
}

TEST(LaserScanner, LosesEchoesWhereBeamsGraze) {
  ScannerOptions options = idealScanner(20000);
  options.at = {{20, 0, 1}};
  const auto edgeShare = [&](double loss) {
    options.grazingLoss = loss;
    const SimulatedScan result = scan(test::stick(4), options, 1);
    const auto edge = std::count_if(result.points.positions.begin(), result.points.positions.end(),
                                    [](const Vector3d& p) { return std::abs(p.y()) > 0.09; });
    return static_cast<double>(edge) / static_cast<double>(result.nodes.size());
  };
  EXPECT_NEAR(edgeShare(0), 0.1, 0.02); // even across the stick, as seen
  EXPECT_LT(edgeShare(1), 0.08);
}

TEST(LaserScanner, HasNoPointsWhereLeavesHidTheWood) {
  const Skeleton plant = test::stick(40);
  ScannerOptions options = idealScanner(8000);
  options.clumps = 1;
  options.clumpRadius = 0.1;
  const SimulatedScan result = scan(plant, options, 2);
  std::vector<bool> seen(plant.idEnd());
  for (const auto& node : result.nodes)
    seen[indexOf(*node)] = true;
  const auto hidden = std::count(seen.begin() + 1, seen.end(), false);
  EXPECT_GE(hidden, 3); // a tenth of the extent on both sides: 8, fewer at an end
  EXPECT_LE(hidden, 9);
}

TEST(LaserScanner, RefusesWhatItCannotScan) {
  const Skeleton plant = test::stick(3);
  const auto run = [](const Skeleton& s, const ScannerOptions& options) {
    static_cast<void>(scan(s, options, 1));
  };
  EXPECT_THROW(run({}, {}), Error);
  EXPECT_THROW(run(test::stick(1), {}), Error);
  EXPECT_THROW(run(plant, {.points = 0}), Error);
  EXPECT_THROW(run(plant, {.stations = 0}), Error);
  EXPECT_THROW(run(plant, {.distance = std::nan("")}), Error);
  EXPECT_THROW(run(plant, {.rangeNoise = -1}), Error);
  EXPECT_THROW(run(plant, {.misalignment = std::nan("")}), Error);
  EXPECT_THROW(run(plant, {.beamWidth = 9}), Error);
  EXPECT_THROW(run(plant, {.strayShare = 1}), Error);
  EXPECT_THROW(run(plant, {.clumps = -1}), Error);
  EXPECT_THROW(run(plant, {.at = {{std::nan(""), 0, 0}}}), Error);
}

TEST(LaserScanner, SaysSoIfNoBeamHits) {
  ScannerOptions options = idealScanner(100);
  options.clumps = 50;
  options.clumpRadius = 1; // leaves over all of it
  EXPECT_THROW(static_cast<void>(scan(test::stick(3), options, 1)), Error);
}

TEST(LaserScanner, StopsWhenAskedTo) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(scan(test::stick(3), {}, 1, Progress(source.get_token(), {}))),
               Cancelled);
}

} // namespace
} // namespace espalier
