#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/graph/find_root.h"
#include "core/reconstruct/geodesic_bins.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

constexpr GeodesicBinOptions binOptions{.neighbors = 10, .binWidth = 0.15};

Skeleton skeletonOf(const Eigen::Matrix3Xf& points) {
  return skeletonByGeodesicBins(points, findRoot(points), binOptions);
}

TEST(GeodesicBins, FindTheForkOfAFork) {
  const Skeleton skeleton = skeletonOf(test::forkCloud());
  ASSERT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 2);
  // The bin of the fork holds both arms where they touch: its node stands up to half a bin between
  // them.
  EXPECT_LT(test::farthestFromFork(skeleton), binOptions.binWidth / 2 + 0.04);
  EXPECT_NEAR(static_cast<double>(skeleton.size()), (2 + 1.5 + 1.5) / 0.15, 3);
}

TEST(GeodesicBins, JoinWhatAGapParts) {
  const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, 0.04, 0.02),
                                             test::cylinder({0, 0, 1.3}, {0, 0, 2}, 0.04, 0.02));
  const Skeleton skeleton = skeletonOf(points);
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 1);
}

/// A trunk, a branch that winds out to (0.9, 0, 0.5) and back to (0.5, 0, 1), from where it rises,
/// and a twig of the trunk that touches it there.
Eigen::Matrix3Xf touchingWood() {
  const auto wood = [](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return test::cylinder(from, to, 0.03, 0.02);
  };
  Eigen::Matrix3Xf points = wood({0, 0, 0}, {0, 0, 2});
  points = test::both(points, wood({0, 0, 0.3}, {0.9, 0, 0.5}));
  points = test::both(points, wood({0.9, 0, 0.5}, {0.5, 0, 1}));
  points = test::both(points, wood({0.5, 0, 1}, {0.5, 0, 2}));
  return test::both(points, wood({0, 0, 1}, {0.5, 0, 1}));
}

/// How near the path from the node nearest to `from` down to the root comes to `place`.
double nearestOnPath(const Skeleton& skeleton, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& place) {
  const std::vector<NodeId> ids = skeleton.ids();
  const auto distance = [&](NodeId id, const Eigen::Vector3d& to) {
    return (skeleton[id].position - to).norm();
  };
  std::optional<NodeId> at =
      *std::ranges::min_element(ids, {}, [&](NodeId id) { return distance(id, from); });
  double nearest = distance(*at, place);
  for (; at; at = skeleton[*at].parent)
    nearest = std::min(nearest, distance(*at, place));
  return nearest;
}

TEST(GeodesicBins, AttachTouchingWoodToTheWoodItRunsAlongIfTurnsCost) {
  const Eigen::Matrix3Xf points = touchingWood();
  const Eigen::Vector3d tip(0.5, 0, 2);
  const Eigen::Vector3d bend(0.9, 0, 0.5); // the branch; by the twig the path is shorter
  EXPECT_GT(nearestOnPath(skeletonOf(points), tip, bend), 0.5);
  GeodesicBinOptions turning = binOptions;
  turning.turnCost = 5;
  const Skeleton skeleton = skeletonByGeodesicBins(points, findRoot(points), turning);
  EXPECT_LT(nearestOnPath(skeleton, tip, bend), 0.15);
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(skeleton.size(), skeletonOf(points).size()) << "the same nodes, attached otherwise";
}

TEST(GeodesicBins, FindTheForkOfAForkIfTurnsCost) {
  GeodesicBinOptions turning = binOptions;
  turning.turnCost = 5;
  const Eigen::Matrix3Xf points = test::forkCloud();
  EXPECT_EQ(test::countTips(skeletonByGeodesicBins(points, findRoot(points), turning)), 2);
}

/// Wood that parts in two at 0.5, `apart` from each other, and meets again at 1.5.
Eigen::Matrix3Xf partedWood(double apart) {
  const auto wood = [](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return test::cylinder(from, to, 0.02, 0.015);
  };
  Eigen::Matrix3Xf points = test::both(wood({0, 0, 0}, {0, 0, 0.5}), wood({0, 0, 1.5}, {0, 0, 2}));
  for (const double x : {-apart / 2, apart / 2}) {
    points = test::both(points, wood({0, 0, 0.5}, {x, 0, 0.7}));
    points = test::both(points, wood({x, 0, 0.7}, {x, 0, 1.3}));
    points = test::both(points, wood({x, 0, 1.3}, {0, 0, 1.5}));
  }
  return points;
}

TEST(GeodesicBins, MakeOneLineOfTheSidesOfARing) {
  const Eigen::Matrix3Xf points = partedWood(0.15);
  const Skeleton skeleton = skeletonOf(points);
  EXPECT_EQ(test::countTips(skeleton), 1);
  for (const NodeId id : skeleton.ids())
    EXPECT_LT(skeleton[id].position.head<2>().norm(), 0.03);
  GeodesicBinOptions both = binOptions;
  both.ring = 0;
  EXPECT_EQ(test::countTips(skeletonByGeodesicBins(points, findRoot(points), both)), 2);
}

TEST(GeodesicBins, KeepWoodThatMeetsAgainWhereItLiesFartherApart) {
  const Eigen::Matrix3Xf points = partedWood(0.5);
  EXPECT_EQ(test::countTips(skeletonOf(points)), 2);
}

TEST(GeodesicBins, KeepOutWhatIsFartherThanTheWidestGap) {
  const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.04, 0.02),
                                             test::cylinder({1, 0, 1}, {1, 0, 2}, 0.04, 0.02));
  GeodesicBinOptions strict = binOptions;
  strict.widestGap = 0.3;
  const Skeleton skeleton = skeletonByGeodesicBins(points, findRoot(points), strict);
  EXPECT_NEAR(static_cast<double>(skeleton.size()), 2 / 0.15, 2);
}

TEST(GeodesicBins, RefuseARootThatCarriesLessThanHalf) {
  const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, {0, 0, 0.5}, 0.04, 0.02),
                                             test::cylinder({9, 0, 0}, {9, 0, 3}, 0.04, 0.02));
  GeodesicBinOptions strict = binOptions;
  strict.widestGap = 1;
  EXPECT_THROW((void)skeletonByGeodesicBins(points, 0, strict), Error);
}

TEST(GeodesicBins, FollowMovingTurningAndScaling) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Skeleton skeleton = skeletonByGeodesicBins(points, 0, binOptions);
  Eigen::Affine3f change = Eigen::Affine3f::Identity();
  change.scale(1000).rotate(Eigen::AngleAxisf(1, Eigen::Vector3f(1, 2, 3).normalized()));
  GeodesicBinOptions scaled = binOptions;
  scaled.binWidth = 1000 * binOptions.binWidth;
  const Skeleton moved = skeletonByGeodesicBins(change * points, 0, scaled);
  ASSERT_EQ(moved.size(), skeleton.size());
  const std::vector<NodeId> ids = skeleton.ids();
  for (const NodeId id : ids)
    EXPECT_LT((moved[id].position - change.cast<double>() * skeleton[id].position).norm(), 20);
}

TEST(GeodesicBins, AreTheSameOnAnyNumberOfThreads) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Skeleton onMany = skeletonOf(points);
  const ThreadLimit limit(1);
  EXPECT_EQ(skeletonOf(points), onMany);
}

TEST(GeodesicBins, CopeWithTwoAndWithCoincidentPoints) {
  Eigen::Matrix3Xf two(3, 2);
  two << 0, 0, 0, 0, 0, 1;
  EXPECT_EQ(skeletonByGeodesicBins(two, 0, binOptions).size(), 2U);
  EXPECT_EQ(skeletonByGeodesicBins(Eigen::Matrix3Xf::Ones(3, 100), 0, binOptions).size(), 1U);
}

TEST(GeodesicBins, StopWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)skeletonByGeodesicBins(test::forkCloud(), 0, binOptions, progress);
  }));
}

} // namespace
} // namespace espalier
