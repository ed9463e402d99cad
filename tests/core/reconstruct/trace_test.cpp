#include "core/reconstruct/centered_line.h"
#include "core/reconstruct/trace.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"
#include "tests/support/clouds.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const PointCloud> cloudOf(const Eigen::Matrix3Xf& points,
                                          const Vector3d& place = Vector3d::Zero()) {
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>() + place);
  return std::make_shared<const PointCloud>(std::move(raw));
}

/// Upright, 2 long, radius 0.1, points 0.02 apart.
Eigen::Matrix3Xf pole() {
  return test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.02);
}

/// Two paths from the origin to (2, 0, 0): straight, and by (0, 0, 0.4), (2, 0, 0.4).
Eigen::Matrix3Xf frame() {
  const auto bar = [](const Vector3d& from, const Vector3d& to) {
    return test::cylinder(from, to, 0.03, 0.015);
  };
  return test::both(test::both(bar({0, 0, 0}, {2, 0, 0}), bar({0, 0, 0}, {0, 0, 0.4})),
                    test::both(bar({0, 0, 0.4}, {2, 0, 0.4}), bar({2, 0, 0.4}, {2, 0, 0})));
}

double highest(const Trace& trace) {
  double z = 0;
  for (const Vector3d& place : trace.places)
    z = std::max(z, place.z());
  return z;
}

TEST(Trace, RunsInTheMiddleOfTheWood) {
  const TraceGraph graph(cloudOf(pole()));
  const Trace trace = graph.between({{0.1, 0, 0.2}}, {{-0.1, 0, 1.8}}, {.step = 0.2}).front();
  ASSERT_GE(trace.places.size(), 8U);
  for (const Vector3d& place : trace.places)
    EXPECT_LT(place.head<2>().norm(), 0.02);
  for (const double radius : trace.radii)
    EXPECT_NEAR(radius, 0.1, 0.01);
  EXPECT_NEAR(trace.length(), 1.6, 0.1);
}

// Contraction draws the ends of wood in, by most of its radius of 7.5 point spacings.
TEST(Trace, ReachesThePointsItWasStartedAndEndedAt) {
  const TraceGraph graph(cloudOf(pole()));
  const Trace trace = graph.between({{0.1, 0, 0}}, {{0, 0.1, 2}}, {.step = 0.2}).front();
  EXPECT_NEAR(trace.places.front().z(), 0, 0.03);
  EXPECT_NEAR(trace.places.back().z(), 2, 0.03);
  const Trace drawn = graph.through({{0, 0, 1}, {0, 0.1, 1.5}, {0, 0.1, 2}}, true, {.step = 0.2});
  EXPECT_NEAR(drawn.places.back().z(), 2, 0.03);
  for (const Vector3d& place : drawn.places)
    EXPECT_LT(place.head<2>().norm(), 0.02);
}

TEST(Trace, SpacesItsPlacesEvenly) {
  const TraceGraph graph(cloudOf(pole()));
  const Trace trace = graph.between({{0, 0, 0}, true}, {{0, 0, 2}, true}, {.step = 0.25}).front();
  ASSERT_EQ(trace.places.size(), 9U); // 2 / 0.25 edges
  for (std::size_t i = 1; i < trace.places.size(); ++i)
    EXPECT_NEAR((trace.places[i] - trace.places[i - 1]).norm(), 0.25, 0.05);
}

// Half a circle of radius 0.5: edges of 0.8 would cut it by 0.18.
TEST(Trace, SpacesItsPlacesCloserInABend) {
  const double spacing = 0.02;
  RawPoints raw;
  const auto bend = [](double along) {
    const double angle = along * std::numbers::pi;
    return Vector3d(0.5 * std::sin(angle), 0, 0.5 - 0.5 * std::cos(angle));
  };
  for (int i = 0; i <= 400; ++i) { // 0.03 thick
    const double angle = 2.4 * i;
    const Vector3d out = (bend(i / 400.0) - Vector3d(0, 0, 0.5)).normalized();
    raw.positions.emplace_back(
        bend(i / 400.0) + 0.03 * (std::cos(angle) * out + std::sin(angle) * Vector3d(0, 1, 0)));
  }
  const TraceGraph graph(std::make_shared<const PointCloud>(std::move(raw)));
  const Trace trace =
      graph.between({bend(0), true}, {bend(1), true}, {.step = 0.8, .alternatives = 0}).front();
  for (int i = 0; i <= 100; ++i)
    EXPECT_LT(distanceToLine(bend(i / 100.0), trace.places), 1.5 * spacing) << i;
  EXPECT_LT(trace.places.size(), 16U) << "but not at each point";
}

TEST(Trace, FoldsBackNowhereThoughItsStepsAreShorterThanThePointsAreApart) {
  const TraceGraph graph(cloudOf(pole()));
  const Trace trace = graph.between({{0.1, 0, 0.2}}, {{-0.1, 0, 1.8}}, {.step = 0.004}).front();
  for (std::size_t i = 2; i < trace.places.size(); ++i) {
    const Vector3d below = trace.places[i - 1] - trace.places[i - 2];
    const Vector3d above = trace.places[i] - trace.places[i - 1];
    EXPECT_GT(below.dot(above), 0);
  }
}

// One looks past the pole here and there, at wood 1 behind it.
TEST(Trace, LeavesOutWhatAStrokePicksOnOtherWood) {
  const Eigen::Matrix3Xf behind = test::cylinder({0, 1, 0}, {0, 1, 2}, 0.1, 0.02);
  const TraceGraph graph(cloudOf(test::both(pole(), behind)));
  std::vector<Vector3d> picked;
  for (int i = 0; i < 40; ++i)
    picked.emplace_back(0, i % 10 < 3 && i > 0 ? 0.9 : -0.1, 0.2 + 0.04 * i);
  const Trace trace = graph.through(picked, false, {.step = 0.2});
  for (const Vector3d& place : trace.places)
    EXPECT_LT(place.head<2>().norm(), 0.1);
}

TEST(Trace, EndsExactlyAtNodes) {
  const TraceGraph graph(cloudOf(pole()));
  const Vector3d from(0.01, 0.02, 0.1);
  const Vector3d to(-0.02, 0.01, 1.9);
  for (const Trace& trace : graph.between({from, true}, {to, true}, {.step = 0.2})) {
    EXPECT_EQ(trace.places.front(), from);
    EXPECT_EQ(trace.places.back(), to);
    EXPECT_EQ(trace.places.size(), trace.radii.size());
  }
}

TEST(Trace, FollowsTheArmsOfAForkAndNotTheAirBetween) {
  const TraceGraph graph(cloudOf(test::forkCloud()));
  const double turn = 35 * std::numbers::pi / 180;
  const Vector3d arm(1.4 * std::sin(turn), 0, 1.4 * std::cos(turn));
  const Vector3d top(0, 0, 2);
  const Vector3d otherArm(-arm.x(), 0, arm.z());
  const Trace trace =
      graph.between({top + arm, true}, {top + otherArm, true}, {.step = 0.1}).front();
  EXPECT_NEAR(trace.length(), 2.8, 0.2); // down one arm and up the other
  for (const Vector3d& place : trace.places) {
    const Vector3d mirrored(std::abs(place.x()), place.y(), place.z());
    EXPECT_LT(distanceToLine(mirrored, {{0, 0, 1.5}, top, top + 1.1 * arm}), 0.06);
  }
}

/// The largest share of the wood's radius that a place of the trace is off the true axis, where
/// the wood is thick enough for the scan to show; elsewhere it is taken as `finest` thick.
double farthestOff(const Trace& trace, const Skeleton& truth, double finest) {
  const EdgeIndex index(truth);
  double farthest = 0;
  for (const Vector3d& place : trace.places) {
    const auto nearest = index.nearest(place);
    farthest =
        std::max(farthest, nearest->distance / std::max(truth[nearest->node].radius, finest));
  }
  return farthest;
}

Axis longestAxis(const Skeleton& skeleton) {
  Axis longest;
  for (const Axis& axis : axes(skeleton))
    if (axis.size() > longest.size()) longest = axis;
  return longest;
}

TEST(Trace, StaysWithinTheWoodOfASimulatedHerb) {
  const test::SimulatedPlant& herb = test::simulatedHerb();
  const auto cloud = std::make_shared<const PointCloud>(herb.cloud);
  const TraceGraph graph(cloud);
  for (const Axis& axis : axes(herb.truth)) {
    if (axis.size() < 4) continue;
    const Vector3d from = herb.truth[axis.front()].position;
    const Vector3d to = herb.truth[axis.back()].position;
    const Trace trace = graph.between({from, true}, {to, true}, {.step = 10}).front();
    EXPECT_LT(farthestOff(trace, herb.truth, graph.spacing()), 1);
    EXPECT_NEAR(trace.length(), length(herb.truth, axis), 0.15 * trace.length() + 10);
  }
}

TEST(Trace, StaysWithinTheWoodOfAScannedTree) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const TraceGraph graph(std::make_shared<const PointCloud>(tree.cloud));
  Axis axis = longestAxis(tree.truth); // as far as the points can show its wood
  while (tree.truth[axis.back()].radius < 1.5 * graph.spacing())
    axis.pop_back();
  const Vector3d from = tree.truth[axis.front()].position;
  const Vector3d to = tree.truth[axis.back()].position;
  const Trace trace = graph.between({from, true}, {to, true}, {.step = 0.1}).front();
  EXPECT_GT(trace.length(), 2);
  EXPECT_LT(farthestOff(trace, tree.truth, 0), 1);
}

TEST(Trace, OffersAnotherPathWhereThereIsOne) {
  const TraceGraph graph(cloudOf(frame()));
  const std::vector<Trace> traces =
      graph.between({{0, 0, 0}, true}, {{2, 0, 0}, true}, {.step = 0.1});
  ASSERT_EQ(traces.size(), 2U);
  EXPECT_LT(highest(traces[0]), 0.1);
  EXPECT_NEAR(highest(traces[1]), 0.4, 0.05);
}

TEST(Trace, OffersNoOtherPathAlongASinglePole) {
  const TraceGraph graph(cloudOf(pole()));
  EXPECT_EQ(graph.between({{0, 0, 0.1}, true}, {{0, 0, 1.9}, true}, {.step = 0.1}).size(), 1U);
}

TEST(Trace, CrossesAGapInTheScan) {
  const TraceGraph graph(cloudOf(test::both(test::cylinder({0, 0, 0}, {0, 0, 0.9}, 0.05, 0.02),
                                            test::cylinder({0, 0, 1.1}, {0, 0, 2}, 0.05, 0.02))));
  const Trace trace = graph.between({{0.05, 0, 0.1}}, {{0.05, 0, 1.9}}, {.step = 0.1}).front();
  EXPECT_NEAR(trace.length(), 1.8, 0.1);
}

TEST(Trace, HasNoPlaceInAGap) {
  const TraceGraph graph(cloudOf(test::both(test::cylinder({0, 0, 0}, {0, 0, 0.9}, 0.01, 0.01),
                                            test::cylinder({0, 0, 1.3}, {0, 0, 2}, 0.01, 0.01))));
  const Trace trace = graph.between({{0, 0, 0.1}}, {{0, 0, 1.9}}, {.step = 0.1}).front();
  for (const Vector3d& place : trace.places)
    EXPECT_TRUE(place.z() < 0.92 || place.z() > 1.28) << place.z();
  EXPECT_NEAR(trace.length(), 1.8, 0.1);
}

TEST(Trace, MovesWithTheScan) {
  const Vector3d shift(1000, 2000, -500);
  const TraceGraph here(cloudOf(pole()));
  const TraceGraph there(cloudOf(pole(), shift));
  const Vector3d from(0.1, 0, 0.2);
  const Vector3d to(0, 0.1, 1.8);
  const Trace a = here.between({from}, {to}, {.step = 0.2}).front();
  const Trace b = there.between({from + shift}, {to + shift}, {.step = 0.2}).front();
  ASSERT_EQ(a.places.size(), b.places.size());
  for (std::size_t i = 0; i < a.places.size(); ++i)
    EXPECT_LT((a.places[i] + shift - b.places[i]).norm(), 0.01);
}

TEST(Trace, FromAPlaceToItselfStaysThere) {
  const TraceGraph graph(cloudOf(pole()));
  const Vector3d place(0, 0, 1);
  for (const Trace& trace : graph.between({place, true}, {place, true}, {.step = 0.2}))
    for (const Vector3d& each : trace.places)
      EXPECT_LT((each - place).norm(), 0.2);
}

TEST(Trace, TakesACloudOfOnePoint) {
  const TraceGraph graph(cloudOf(Eigen::Matrix3Xf::Zero(3, 1)));
  const std::vector<Trace> traces = graph.between({{0, 0, 0}}, {{0, 0, 1}, true}, {.step = 0.5});
  ASSERT_EQ(traces.size(), 1U);
  EXPECT_EQ(traces.front().places.back(), Vector3d(0, 0, 1));
}

TEST(Trace, MovesAStrokeOverTheBarkIntoTheWood) {
  const TraceGraph graph(cloudOf(pole()));
  const Trace trace =
      graph.through({{0.1, 0, 0.5}, {0.09, 0.04, 0.9}, {0.1, 0, 1.5}}, false, {.step = 0.1});
  EXPECT_EQ(trace.places.size(), 11U);
  for (const Vector3d& place : trace.places)
    EXPECT_LT(place.head<2>().norm(), 0.03);
}

TEST(Trace, StopsWhenAsked) {
  const auto cloud = cloudOf(pole());
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)TraceGraph(cloud, nullptr, progress); }));
}

TEST(CenteredLine, SpacesPlacesAlongBends) {
  const std::vector<Vector3d> bend = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  const std::vector<Vector3d> even = spacedEvenly(bend, 0.4);
  ASSERT_EQ(even.size(), 6U);
  EXPECT_NEAR((even[1] - Vector3d(0.4, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((even[3] - Vector3d(1, 0.2, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(even.back(), bend.back());
}

TEST(CenteredLine, TakesALineWithoutLength) {
  const std::vector<Vector3d> even = spacedEvenly({{1, 2, 3}, {1, 2, 3}}, 0.1);
  EXPECT_EQ(even, (std::vector<Vector3d>{{1, 2, 3}, {1, 2, 3}}));
}

/// Points on a circle of radius 0.5 about (1, 0, 0) across z, and those of a twig that leaves it.
std::vector<Vector3d> ringWithTwig() {
  std::vector<Vector3d> points;
  for (int i = 0; i < 60; ++i) {
    const double turn = i * std::numbers::pi / 30;
    points.emplace_back(1 + 0.5 * std::cos(turn), 0.5 * std::sin(turn), 0.01 * i);
  }
  for (int i = 0; i < 20; ++i)
    points.emplace_back(1.55 + 0.05 * i, 0, 0.1);
  return points;
}

TEST(CenteredLine, FindsTheMiddleOfASectionThatATwigLeaves) {
  const auto section = sectionAt({1.4, 0, 0}, Vector3d::UnitZ(), ringWithTwig());
  ASSERT_TRUE(section);
  EXPECT_LT((section->middle - Vector3d(1, 0, 0)).norm(), 0.05); // a tenth of the radius
  EXPECT_NEAR(section->radius, 0.5, 0.05);
}

TEST(CenteredLine, TrustsNoSectionBesideThePlace) {
  EXPECT_FALSE(sectionAt({3, 0, 0}, Vector3d::UnitZ(), ringWithTwig()));
}

TEST(CenteredLine, TrustsNoSectionOfFewPoints) {
  EXPECT_FALSE(sectionAt({0, 0, 0}, Vector3d::UnitZ(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(sectionAt({0, 0, 0}, Vector3d::UnitZ(), {}));
}

} // namespace
} // namespace espalier
