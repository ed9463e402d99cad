#include "core/base/error.h"
#include "core/graph/find_root.h"
#include "core/reconstruct/graph_colonization.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

constexpr GraphColonizationOptions colonizationOptions{
    .neighbors = 10, .leastStep = 0.1, .greatestStep = 0.2, .widestGap = 0.3};

/// A line of points upwards, 0.01 apart.
Eigen::Matrix3Xf line(double from, double to) {
  const auto count = static_cast<Eigen::Index>((to - from) / 0.01 + 1.5);
  Eigen::Matrix3Xf points = Eigen::Matrix3Xf::Zero(3, count);
  points.row(2) =
      Eigen::RowVectorXf::LinSpaced(count, static_cast<float>(from), static_cast<float>(to));
  return points;
}

Skeleton skeletonOf(const Eigen::Matrix3Xf& points, float density,
                    const GraphColonizationOptions& with = colonizationOptions) {
  const std::vector<float> densities(static_cast<std::size_t>(points.cols()), density);
  return skeletonByGraphColonization(points, densities, 0, with);
}

// 1 / 0.1 and 1 / 0.2 groups above that of the root.
TEST(GraphColonization, StepsFartherWherePointsAreDense) {
  EXPECT_NEAR(static_cast<double>(skeletonOf(line(0, 1), 0).size()), 10, 1);
  EXPECT_NEAR(static_cast<double>(skeletonOf(line(0, 1), 1).size()), 5, 1);
}

// Dense below, sparse above: half of 1 / 0.2 and half of 1 / 0.1.
TEST(GraphColonization, ChangesItsStepWithTheDensityOnThePath) {
  const Eigen::Matrix3Xf points = line(0, 1);
  std::vector<float> densities(static_cast<std::size_t>(points.cols()), 1);
  std::fill(densities.begin() + 50, densities.end(), 0.0F);
  const Skeleton skeleton = skeletonByGraphColonization(points, densities, 0, colonizationOptions);
  EXPECT_NEAR(static_cast<double>(skeleton.size()), 2.5 + 5, 1);
}

TEST(GraphColonization, PutsNodesBetweenTheMeanAndTheJunctionOfTheirPoints) {
  GraphColonizationOptions atJunctions = colonizationOptions;
  atJunctions.junctionShare = 1;
  const Skeleton means = skeletonOf(line(0, 1), 0);
  const Skeleton junctions = skeletonOf(line(0, 1), 0, atJunctions);
  ASSERT_EQ(means.size(), junctions.size());
  const std::vector<NodeId> ids = means.ids();
  for (std::size_t i = 1; i + 1 < ids.size(); ++i) // the points of a group are 0.1 long
    EXPECT_NEAR(means[ids[i]].position.z() - junctions[ids[i]].position.z(), 0.05, 0.06);
  EXPECT_LT(junctions[ids[1]].position.z(), means[ids[1]].position.z());
}

TEST(GraphColonization, FindsTheForkOfAFork) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const std::vector<float> densities(static_cast<std::size_t>(points.cols()), 0.5F);
  const Skeleton skeleton =
      skeletonByGraphColonization(points, densities, findRoot(points), colonizationOptions);
  const std::vector<NodeId> ids = skeleton.ids();
  EXPECT_EQ(std::ranges::count_if(ids, [&](NodeId id) { return skeleton.children(id).empty(); }),
            2);
  EXPECT_LT(test::farthestFromFork(skeleton), 0.15 / 2 + 0.04);
}

// The next points are 0.25 off, and a step is 0.1 long.
TEST(GraphColonization, SleepsBeforeAGapAndWakesBehindIt) {
  const Skeleton skeleton = skeletonOf(test::both(line(0, 1), line(1.25, 2)), 0);
  ASSERT_EQ(skeleton.roots().size(), 1U);
  double top = 0;
  for (const NodeId id : skeleton.ids()) {
    EXPECT_LE(skeleton.children(id).size(), 1U);
    top = std::max(top, skeleton[id].position.z());
  }
  EXPECT_GT(top, 1.9);
}

TEST(GraphColonization, RefusesARootThatCarriesLessThanHalf) {
  EXPECT_THROW((void)skeletonOf(test::both(line(0, 0.5), line(9, 12)), 0), Error);
}

TEST(GraphColonization, MakesOneNodeOfCoincidentPoints) {
  EXPECT_EQ(skeletonOf(Eigen::Matrix3Xf::Ones(3, 50), 0.5F).size(), 1U);
  EXPECT_EQ(skeletonOf(Eigen::Matrix3Xf::Ones(3, 1), 0.5F).size(), 1U);
}

TEST(GraphColonization, StopsWhenAsked) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const std::vector<float> densities(static_cast<std::size_t>(points.cols()), 0.5F);
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)skeletonByGraphColonization(points, densities, 0, colonizationOptions, progress);
  }));
}

} // namespace
} // namespace espalier
