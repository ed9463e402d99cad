#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/presets.h"
#include "core/pipeline/region_preview.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace espalier {
namespace {

/// The fork of test::forkCloud(), far from the origin of its file, and a ball about where it forks.
struct RegionPreviews : testing::Test {
  Eigen::Vector3d place = {500, 600, 700};
  std::shared_ptr<const PointCloud> cloud = test::cloudOf(test::forkCloud(), place);
  Ball ball{place + Eigen::Vector3d(0, 0, 2), 0.5};
  PipelineOptions options;
  Pipeline pipeline;

  Reconstruction whole(const std::string& last = "contract") {
    return pipeline.run(cloud, options, {}, last);
  }
  RegionPreviewer previewer() {
    return RegionPreviewer(cloud, options.leftOut, whole().scale, options.up, options.root);
  }
  /// How far the preview is from the run on the whole cloud [spacings].
  double greatestDifference() {
    const Reconstruction all = whole();
    const RegionPreview part = previewer().contracted(ball, options);
    EXPECT_GT(part.points.size(), 100U);
    EXPECT_LT(part.points.size(), static_cast<std::size_t>(cloud->size()) / 2);
    double greatest = 0;
    for (std::size_t i = 0; i < part.points.size(); ++i)
      greatest = std::max(greatest,
                          static_cast<double>((part.contracted.col(static_cast<Eigen::Index>(i)) -
                                               all.contracted->col(part.points[i]))
                                                  .norm()));
    return greatest / all.scale.spacing;
  }
};

TEST_F(RegionPreviews, HoldThePointsOfTheBall) {
  const std::vector<Eigen::Index> points = previewer().contracted(ball, options).points;
  std::vector<Eigen::Index> expected;
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if ((cloud->position(i) - ball.center).norm() <= ball.radius) expected.push_back(i);
  EXPECT_EQ(points, expected);
}

TEST_F(RegionPreviews, HoldNoPointsThatWereSetAside) {
  options.leftOut = PointSet::firstOf(cloud->size() / 2);
  for (const Eigen::Index point : previewer().contracted(ball, options).points)
    EXPECT_FALSE(options.leftOut.contains(point));
}

/// Each point nine times, and one far below.
std::shared_ptr<const PointCloud> oddCloud(const Eigen::Vector3d& place) {
  Eigen::Matrix3Xf points = Eigen::Vector3f(0, 0, -900);
  for (int copy = 0; copy < 9; ++copy)
    points = test::both(points, test::forkCloud());
  return test::cloudOf(points, place);
}

TEST_F(RegionPreviews, AreTheSameBesideAStrayAndOfRepeatedPoints) {
  options.methods["contract"] = "path_based"; // it sees how far the root is
  const RegionPreview plain = previewer().reconstructed(ball, options);
  cloud = oddCloud(place);
  const RegionPreview odd = previewer().reconstructed(ball, options);
  EXPECT_EQ(odd.skeleton, plain.skeleton);
  ASSERT_EQ(odd.points.size(), 9 * plain.points.size());
  for (Eigen::Index i = 0; i < odd.contracted.cols(); ++i)
    ASSERT_EQ(odd.contracted.col(i), plain.contracted.col(i / 9));
}

TEST_F(RegionPreviews, AgreeWithARunOnTheWholeWhereAContractionLooksNoFartherThanItsOptions) {
  for (const char* method :
       {"geodesic_centroid", "adaptive_geodesic", "euclidean_ball", "one_step_laplacian", "none"}) {
    options.methods["contract"] = method;
    EXPECT_LT(greatestDifference(), 1e-5) << method;
  }
  options.methods["contract"] = "geodesic_centroid";
  options.set("contract.circles=yes");
  EXPECT_LT(greatestDifference(), 1e-5) << "with circles";
  options.settings.clear();
  options.set("contract.method=adaptive_sections");
  options.set("contract.most_radius=0.15"); // its default is wider than the margin
  EXPECT_LT(greatestDifference(), 1e-5) << "adaptive_sections";
}

TEST_F(RegionPreviews, AreMadeByEveryContraction) {
  for (const Method& method : stepNamed("contract").methods) {
    options.methods["contract"] = method.name;
    const RegionPreview part = previewer().reconstructed(ball, options);
    EXPECT_TRUE(part.contracted.allFinite()) << method.name;
    EXPECT_FALSE(part.skeleton.isEmpty()) << method.name;
    for (std::size_t i = 0; i < part.points.size(); ++i) {
      const Eigen::Index column = part.points[i];
      EXPECT_LT((part.contracted.col(static_cast<Eigen::Index>(i)) - cloud->positions().col(column))
                    .norm(),
                0.3)
          << method.name;
    }
  }
}

TEST_F(RegionPreviews, ShowTheSkeletonThatWouldGrow) {
  const RegionPreview part = previewer().reconstructed(ball, options);
  ASSERT_EQ(part.skeleton.roots().size(), 1U) << "one piece of wood is in the ball";
  EXPECT_LT(part.skeleton[part.skeleton.roots().front()].position.z(), ball.center.z() - 0.3)
      << "it grows from where the root is";
  int tips = 0;
  Skeleton atOrigin = part.skeleton;
  for (const NodeId id : part.skeleton.ids()) {
    EXPECT_TRUE(ball.contains(part.skeleton[id].position));
    if (part.skeleton.children(id).empty()) ++tips;
    atOrigin.setPosition(id, part.skeleton[id].position - place);
  }
  EXPECT_EQ(tips, 2) << "two arms leave the ball";
  EXPECT_LT(test::farthestFromFork(atOrigin), 0.04);
}

TEST_F(RegionPreviews, GrowFromTheRootThatIsChosen) {
  options.root = place + Eigen::Vector3d(0.86, 0, 3.2); // the tip of an arm
  const RegionPreview part = previewer().reconstructed(ball, options);
  ASSERT_EQ(part.skeleton.roots().size(), 1U);
  const Eigen::Vector3d root = part.skeleton[part.skeleton.roots().front()].position - place;
  EXPECT_GT(root.x(), 0.1);
  EXPECT_GT(root.z(), 2.2);
}

// Two stems 0.5 apart cross the ball; so does a crumb of 10 points between them.
TEST_F(RegionPreviews, JoinNothingThroughEmptySpace) {
  Eigen::Matrix3Xf crumb = Eigen::Matrix3Xf::Zero(3, 10);
  for (Eigen::Index i = 0; i < crumb.cols(); ++i)
    crumb.col(i) = Eigen::Vector3f(0.25F, 0, 1 + 0.01F * static_cast<float>(i));
  const Eigen::Matrix3Xf stem = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.04, 0.02);
  Eigen::Matrix3Xf other = stem;
  other.row(0).array() += 0.5F;
  cloud = test::cloudOf(test::both(test::both(stem, other), crumb), place);
  ball = {place + Eigen::Vector3d(0.25, 0, 1), 0.5};
  const Skeleton skeleton = previewer().reconstructed(ball, options).skeleton;
  EXPECT_EQ(skeleton.roots().size(), 2U);
  for (const NodeId id : skeleton.ids()) {
    const double x = skeleton[id].position.x() - place.x();
    EXPECT_LT(std::min(std::abs(x), std::abs(x - 0.5)), 0.02);
  }
}

TEST_F(RegionPreviews, MayBeOfAPlaceWithoutPoints) {
  const RegionPreview part =
      previewer().reconstructed({place + Eigen::Vector3d(3, 3, 3), 0.5}, options);
  EXPECT_TRUE(part.points.empty());
  EXPECT_EQ(part.contracted.cols(), 0);
  EXPECT_TRUE(part.skeleton.isEmpty());
}

TEST_F(RegionPreviews, AreEmptyWhereAllPointsAreSetAside) {
  const PlantScale scale = whole().scale;
  options = presetNamed("thesis")->options; // which follows densities, of which there are none
  options.leftOut = PointSet::firstOf(cloud->size());
  RegionPreviewer previewer(cloud, options.leftOut, scale, options.up, options.root);
  EXPECT_TRUE(previewer.contracted(ball, options).points.empty());
}

TEST_F(RegionPreviews, LeavePointsWhereTheyAreThatCleaningLeavesOut) {
  Eigen::Matrix3Xf stray(3, 1);
  stray << 0.45F, 0, 1.9F;
  cloud = test::cloudOf(test::both(test::forkCloud(), stray), place);
  EXPECT_LT(greatestDifference(), 1e-5);
  const RegionPreview part = previewer().contracted(ball, options);
  const Eigen::Vector3f where = stray.col(0) + (place - cloud->origin()).cast<float>();
  const Eigen::Index column = nearestPoint(cloud->positions(), where);
  const auto found = std::ranges::find(part.points, column);
  ASSERT_NE(found, part.points.end());
  EXPECT_EQ(part.contracted.col(found - part.points.begin()), cloud->positions().col(column));
}

TEST_F(RegionPreviews, RefuseValuesOutOfRange) {
  const RegionPreviewer preview = previewer();
  options.set("contract.radius=1e6");
  EXPECT_THROW((void)preview.contracted(ball, options), Error);
  options.settings.clear();
  options.set("prune.length=-1");
  EXPECT_THROW((void)preview.reconstructed(ball, options), Error);
}

TEST_F(RegionPreviews, AreTheSameOnAnyNumberOfThreads) {
  const RegionPreview onMany = previewer().reconstructed(ball, options);
  const ThreadLimit limit(1);
  const RegionPreview onOne = previewer().reconstructed(ball, options);
  EXPECT_EQ(onMany.contracted, onOne.contracted);
  EXPECT_EQ(onMany.skeleton, onOne.skeleton);
}

TEST_F(RegionPreviews, StopWhenAsked) {
  const RegionPreviewer preview = previewer();
  const auto stops = [&] {
    return test::stopsWhenAsked(
        [&](const Progress& progress) { (void)preview.reconstructed(ball, options, progress); });
  };
  EXPECT_TRUE(stops()) << "at first";
  (void)preview.reconstructed(ball, options);
  EXPECT_TRUE(stops()) << "with what is of the whole at hand";
}

TEST_F(RegionPreviews, KnowTheBallThatHoldsSoManyPoints) {
  const RegionPreviewer preview = previewer();
  for (const Eigen::Index count : {1, 100, 1000}) {
    const Ball found = preview.ballWith(place + Eigen::Vector3d(0.3, 0, 2), count);
    EXPECT_EQ(static_cast<Eigen::Index>(preview.contracted(found, options).points.size()), count);
  }
  const Ball all = preview.ballWith(place, 10 * cloud->size());
  EXPECT_EQ(static_cast<Eigen::Index>(preview.contracted(all, options).points.size()),
            cloud->size());
}

} // namespace
} // namespace espalier
