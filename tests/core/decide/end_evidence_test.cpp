#include "core/decide/end_odds.h"
#include "core/evaluate/study/perturbation.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace espalier {
namespace {

/// A stem of 10 with a lateral of 3 from its middle, sideways.
Skeleton withLateral() {
  Skeleton plant = test::stick(11);
  NodeId parent{5};
  for (int i = 1; i <= 3; ++i)
    parent = plant.add({.position = {static_cast<double>(i), 0, 5}, .parent = parent});
  return plant;
}

/// Points 0.2 beside the stem, on either side, and 0.1 above the lateral: each 0.5 apart.
Eigen::Matrix3Xf pointsOnBoth() {
  Eigen::Matrix3Xf points(3, 47);
  Eigen::Index next = 0;
  for (int i = 0; i <= 20; ++i)
    for (const float side : {-0.2F, 0.2F})
      points.col(next++) = Eigen::Vector3f(0, side, 0.5F * static_cast<float>(i));
  for (int i = 1; i <= 5; ++i)
    points.col(next++) = Eigen::Vector3f(0.5F + 0.5F * static_cast<float>(i), 0, 5.1F);
  return points;
}

const EndsOfSkeleton::End& endWith(const EndsOfSkeleton& ends, NodeId tip) {
  return *std::ranges::find_if(ends.ends(),
                               [&](const auto& end) { return end.end.nodes.front() == tip; });
}

TEST(EndEvidence, IsInSpacings) {
  const Eigen::Matrix3Xf points = pointsOnBoth();
  const EndsOfSkeleton ends(withLateral(), points, Eigen::Vector3d::Zero(), {0.5, 10});
  ASSERT_EQ(ends.ends().size(), 2U);
  const EndEvidence found = endWith(ends, NodeId{13}).evidence;
  EXPECT_DOUBLE_EQ(found.length, 6);
  EXPECT_DOUBLE_EQ(found.protrusion, 6); // from the stem
  EXPECT_NEAR(found.bearer, 0.4, 1e-6);
  EXPECT_EQ(found.points, 5);
  EXPECT_EQ(found.alone, 5); // all more than 0.9 from the stem
  EXPECT_NEAR(found.scatter, 0.2, 1e-6);
  EXPECT_NEAR(found.turn, 0, 1e-12);
  EXPECT_DOUBLE_EQ(found.share, 0.3);
}

TEST(EndEvidence, SaysWhatAllEndsAreLike) {
  const Eigen::Matrix3Xf points = pointsOnBoth();
  const PlantScale scale{.spacing = 0.5, .height = 10, .thickness = 1, .scatter = 0.1};
  const EndsOfSkeleton ends(withLateral(), points, Eigen::Vector3d::Zero(), scale);
  const EndEvidence& lateral = endWith(ends, NodeId{13}).evidence;
  const EndEvidence& stem = endWith(ends, NodeId{10}).evidence;
  const AllEnds& all = lateral.all;
  EXPECT_EQ(all.count, 2);
  EXPECT_DOUBLE_EQ(all.scatter,
                   lateral.scatter);   // the lower median: points of the stem are farther
  EXPECT_NEAR(all.standing, 0, 1e-12); // both stand out by all of their length
  EXPECT_NEAR(all.alone, (shareAlone(lateral) + shareAlone(stem)) / 2, 1e-12);
  EXPECT_NEAR(all.aloneSpread, std::abs(shareAlone(lateral) - shareAlone(stem)) / 2, 1e-12);
  EXPECT_DOUBLE_EQ(all.thickness, 2);
  EXPECT_DOUBLE_EQ(all.noise, 0.2);
  EXPECT_EQ(stem.all.count, 2);
}

// Nothing is known then of what scan they are of.
TEST(EndEvidence, OfAPlantWhoseThicknessIsNotKnownStandsByItself) {
  const Eigen::Matrix3Xf points = pointsOnBoth();
  const EndsOfSkeleton ends(withLateral(), points, Eigen::Vector3d::Zero(), {0.5, 10});
  const EndEvidence& found = ends.ends().front().evidence;
  EXPECT_DOUBLE_EQ(probabilityAmongAll(found), probabilityOfShoot(found));
}

double logOdds(double probability) {
  return std::log(probability / (1 - probability));
}

// What two ends are like says little of all that a plant may have.
TEST(EndEvidence, OfFewEndsStandsByItselfTheMore) {
  const Eigen::Matrix3Xf points = pointsOnBoth();
  const PlantScale scale{.spacing = 0.5, .height = 10, .thickness = 1, .scatter = 0.1};
  const EndsOfSkeleton ends(withLateral(), points, Eigen::Vector3d::Zero(), scale);
  EndEvidence found = ends.ends().front().evidence;
  const double alone = logOdds(probabilityOfShoot(found));
  for (const auto& [count, share] : {std::pair(2, 1.0 / 14), {12, 0.25}, {588, 0.49}}) {
    found.all.count = count;
    const double among = fittedOddsAmongAll().value(featuresAmongAll(found));
    ASSERT_GT(std::abs(among - alone), 0.01);
    EXPECT_NEAR((logOdds(probabilityAmongAll(found)) - alone) / (among - alone), share, 1e-9);
  }
}

TEST(EndEvidence, CountsNoPointThatTheBearerExplains) {
  Eigen::Matrix3Xf points = pointsOnBoth();
  for (Eigen::Index i = 42; i < points.cols(); ++i)
    points(0, i) = 0.6F; // nearer to the lateral than to the stem, but within 0.9 of it
  const EndsOfSkeleton ends(withLateral(), points, Eigen::Vector3d::Zero(), {0.5, 10});
  const EndEvidence found = endWith(ends, NodeId{13}).evidence;
  EXPECT_EQ(found.points, 5);
  EXPECT_EQ(found.alone, 0);
}

TEST(EndEvidence, IsTheSameInAnotherUnitAndPlace) {
  const Eigen::Matrix3Xf points = pointsOnBoth();
  const Eigen::Vector3d origin(3e5, -2e5, 100);
  Skeleton moved = withLateral();
  for (const NodeId id : moved.ids())
    moved.setPosition(id, 1000 * moved[id].position + origin);
  const EndsOfSkeleton here(withLateral(), points, Eigen::Vector3d::Zero(), {0.5, 10});
  const Eigen::Matrix3Xf larger = 1000 * points;
  const EndsOfSkeleton there(moved, larger, origin, {500, 10000});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(here.ends()[i].evidence.protrusion, there.ends()[i].evidence.protrusion, 1e-5);
    EXPECT_NEAR(here.ends()[i].evidence.scatter, there.ends()[i].evidence.scatter, 1e-5);
    EXPECT_EQ(here.ends()[i].evidence.alone, there.ends()[i].evidence.alone);
  }
}

// What is looked at again after ends went is what a fresh look finds, without their points.
TEST(EndEvidence, FollowsWhatIsTakenAway) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const Skeleton plant = perturbed(tree.truth, Perturbation::spurs, 0.3, 1);
  const Eigen::Vector3d& origin = tree.cloud.origin();
  EndsOfSkeleton ends(plant, tree.cloud.positions(), origin, {0.01, 4});
  std::vector<std::size_t> gone;
  std::set<NodeId> feet;
  for (std::size_t i = 0; i < ends.ends().size(); i += 3)
    if (feet.insert(ends.ends()[i].end.foot).second) gone.push_back(i);
  ASSERT_GT(gone.size(), 20U);
  std::set<NodeId> taken;
  for (const std::size_t i : gone)
    taken.insert(ends.ends()[i].end.nodes.begin(), ends.ends()[i].end.nodes.end());
  const auto before = static_cast<double>(ends.ends().size());
  ends.remove(gone);

  std::vector<Eigen::Index> others;
  const EdgeIndex index(plant);
  for (Eigen::Index i = 0; i < tree.cloud.size(); ++i)
    if (!taken.contains(index.nearest(tree.cloud.positions().col(i).cast<double>() + origin)->node))
      others.push_back(i);
  const Eigen::Matrix3Xf points = tree.cloud.positions()(Eigen::all, others);
  const EndsOfSkeleton fresh(ends.skeleton(), points, origin, {0.01, 4});
  ASSERT_EQ(fresh.ends().size(), ends.ends().size());
  for (std::size_t i = 0; i < fresh.ends().size(); ++i) {
    const EndEvidence& a = fresh.ends()[i].evidence;
    const EndEvidence& b = ends.ends()[i].evidence;
    EXPECT_DOUBLE_EQ(a.length, b.length);
    EXPECT_DOUBLE_EQ(a.protrusion, b.protrusion);
    EXPECT_DOUBLE_EQ(a.turn, b.turn);
    EXPECT_EQ(b.all.count, before) << "of those there were at first";
    // Where two edges meet, a point may be given to either.
    EXPECT_NEAR(a.points, b.points, 3) << i;
    EXPECT_NEAR(a.alone, b.alone, 3) << i;
  }
}

TEST(EndEvidence, StopsWhenAsked) {
  const Eigen::Matrix3Xf points = pointsOnBoth();
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)EndsOfSkeleton(withLateral(), points, Eigen::Vector3d::Zero(), {0.5, 10}, progress);
  }));
}

} // namespace
} // namespace espalier
