#include "core/base/parallel.h"
#include "core/contract/geodesic_centroid.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <limits>

namespace espalier {
namespace {

constexpr GeodesicCentroidOptions options{.neighbors = 7, .radius = 0.25};

TEST(GeodesicCentroids, OfACylinderLieOnItsAxis) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 4}, 0.04, 0.02);
  const Eigen::Matrix3Xf contracted = contractedToGeodesicCentroids(points, options);
  ASSERT_EQ(contracted.cols(), points.cols());
  EXPECT_LT(contracted.topRows<2>().colwise().norm().maxCoeff(), 0.2 * 0.04);
}

TEST(GeodesicCentroids, DoNotPullTouchingFreeTwigsTogether) {
  // Two twigs nearer to each other than the radius, joined nowhere.
  const Eigen::Matrix3Xf twig = test::cylinder({0, 0, 0}, {0, 0, 3}, 0.01, 0.02);
  const Eigen::Matrix3Xf other = test::cylinder({0.15, 0, 0}, {0.15, 0, 3}, 0.01, 0.02, 2);
  const Eigen::Matrix3Xf contracted =
      contractedToGeodesicCentroids(test::both(twig, other), options);
  EXPECT_LT(contracted.leftCols(twig.cols()).row(0).maxCoeff(), 0.01F);
  EXPECT_GT(contracted.rightCols(other.cols()).row(0).minCoeff(), 0.14F);
}

TEST(GeodesicCentroids, FollowMovingTurningAndScaling) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Eigen::Matrix3Xf contracted = contractedToGeodesicCentroids(points, options);
  Eigen::Affine3f change = Eigen::Affine3f::Identity();
  change.scale(8).rotate(Eigen::AngleAxisf(1, Eigen::Vector3f(1, 2, 3).normalized()));
  change.pretranslate(Eigen::Vector3f(3, -2, 1));
  const Eigen::Matrix3Xf moved = contractedToGeodesicCentroids(
      change * points, {.neighbors = 7, .radius = 8 * options.radius});
  // Rounding moves a few points across the rim of a ball: they shift a mean by a hair.
  EXPECT_LT((moved - change * contracted).colwise().norm().maxCoeff(), 8 * 0.01);
}

TEST(GeodesicCentroids, AreTheSameOnAnyNumberOfThreads) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Eigen::Matrix3Xf onMany = contractedToGeodesicCentroids(points, options);
  const ThreadLimit limit(1);
  EXPECT_EQ(contractedToGeodesicCentroids(points, options), onMany);
}

TEST(GeodesicCentroids, CopeWithFewAndCoincidentPoints) {
  EXPECT_EQ(contractedToGeodesicCentroids(Eigen::Matrix3Xf(3, 0), options).cols(), 0);
  const Eigen::Matrix3Xf one = Eigen::Matrix3Xf::Ones(3, 1);
  EXPECT_EQ(contractedToGeodesicCentroids(one, options), one);
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 50);
  EXPECT_EQ(contractedToGeodesicCentroids(same, options), same);
}

TEST(GeodesicCentroids, StopWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)contractedToGeodesicCentroids(test::forkCloud(), options, progress);
  }));
}

} // namespace
} // namespace espalier
