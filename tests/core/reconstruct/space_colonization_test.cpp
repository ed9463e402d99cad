#include "core/base/error.h"
#include "core/graph/find_root.h"
#include "core/reconstruct/space_colonization.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

constexpr SpaceColonizationOptions options{
    .leastStep = 0.1, .greatestStep = 0.1, .reach = 2.5, .kill = 1.2, .widestGap = 0.3};

Skeleton colonizedSkeleton(const Eigen::Matrix3Xf& points, Eigen::Index root, float density = 0.5F,
                           const SpaceColonizationOptions& with = options) {
  const std::vector<float> densities(static_cast<std::size_t>(points.cols()), density);
  return skeletonBySpaceColonization(points, densities, root, with);
}

// The last node kills all within 0.12 of it.
TEST(SpaceColonization, ClimbsALineByEvenSteps) {
  const Skeleton skeleton = colonizedSkeleton(line(0, 1), 0);
  const std::vector<NodeId> ids = skeleton.ids();
  EXPECT_EQ(ids.size(), 10U); // at 0, 0.1, ..., 0.9
  for (std::size_t i = 0; i < ids.size(); ++i)
    EXPECT_NEAR(skeleton[ids[i]].position.z(), 0.1 * static_cast<double>(i), 1e-5);
}

// The points on either side pull the root with the same force, or nearly.
TEST(SpaceColonization, GrowsBothWaysFromTheMiddle) {
  const Skeleton skeleton = colonizedSkeleton(line(-1, 1), 100);
  double top = 0;
  double bottom = 0;
  for (const NodeId id : skeleton.ids()) {
    top = std::max(top, skeleton[id].position.z());
    bottom = std::min(bottom, skeleton[id].position.z());
  }
  EXPECT_GT(top, 0.85);
  EXPECT_LT(bottom, -0.85);
}

TEST(SpaceColonization, StepsByTheDensity) {
  SpaceColonizationOptions adaptive = options;
  adaptive.greatestStep = 0.2;
  EXPECT_EQ(colonizedSkeleton(line(0, 1), 0, 0, adaptive).size(), 10U);
  EXPECT_EQ(colonizedSkeleton(line(0, 1), 0, 1, adaptive).size(), 5U); // at 0, 0.2, ..., 0.8
}

TEST(SpaceColonization, TakesAnIndexThatThereIs) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const SpatialIndex index(points);
  const std::vector<float> densities(static_cast<std::size_t>(points.cols()), 0.5F);
  SpaceColonizationOptions with = options;
  for (const double thick : {0.0, 0.02}) { // thick wood is moved: another index is needed
    with.thickWood = thick;
    EXPECT_EQ(skeletonBySpaceColonization(points, densities, 0, with, {}, &index),
              skeletonBySpaceColonization(points, densities, 0, with));
  }
}

TEST(SpaceColonization, FindsTheForkOfAFork) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  SpaceColonizationOptions wide = options; // of wood 0.08 thick that is not contracted
  wide.leastStep = wide.greatestStep = 0.15;
  const Skeleton skeleton = colonizedSkeleton(points, findRoot(points), 0.5F, wide);
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_LT(test::farthestFromFork(skeleton), 0.15 + 0.1); // a step off the wood at most
  double top = 0;
  for (const NodeId id : skeleton.ids())
    top = std::max(top, skeleton[id].position.z());
  EXPECT_GT(top, 2 + 1.5 * 0.819 - 0.2);
}

TEST(SpaceColonization, EndsBeforeAGapWiderThanItsReach) {
  const Skeleton skeleton = colonizedSkeleton(test::both(line(0, 1), line(1.4, 2)), 0);
  for (const NodeId id : skeleton.ids())
    EXPECT_LT(skeleton[id].position.z(), 1.1);
}

TEST(SpaceColonization, RefusesARootThatReachesLessThanHalf) {
  EXPECT_THROW((void)colonizedSkeleton(test::both(line(0, 0.5), line(9, 12)), 0), Error);
}

TEST(SpaceColonization, MakesOneNodeOfCoincidentPoints) {
  EXPECT_EQ(colonizedSkeleton(Eigen::Matrix3Xf::Ones(3, 50), 0).size(), 1U);
  EXPECT_EQ(colonizedSkeleton(Eigen::Matrix3Xf::Ones(3, 1), 0).size(), 1U);
}

TEST(SpaceColonization, BridgesAGapThatIsNarrowEnough) {
  double top = 0;
  const Skeleton skeleton =
      colonizedSkeleton(test::both(line(0, 1), line(1.15, 2)), 0); // from node to point
  for (const NodeId id : skeleton.ids())
    top = std::max(top, skeleton[id].position.z());
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_GT(top, 1.85);
}

TEST(SpaceColonization, TakesASideWhereAllPointsPullApart) {
  Eigen::Matrix3Xf points(3, 3); // the root between two that pull with the same force
  points << 0, 0.2F, -0.2F, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(colonizedSkeleton(points, 0).size(), 3U);
}

} // namespace
} // namespace espalier
