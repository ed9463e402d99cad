#include "core/pipeline/method_sight.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/used_densities.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

struct Sights : testing::Test {
  std::shared_ptr<const PointCloud> cloud = test::cloudOf(test::forkCloud());
  PipelineOptions options;
  Reconstruction result;

  MethodSights sights() {
    result = Pipeline().run(cloud, options);
    return {cloud, result.contracted, options, result.scale};
  }
  [[nodiscard]] Eigen::Vector3d meanOf(const std::vector<Eigen::Index>& points) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Index point : points)
      sum += cloud->position(point);
    return sum / static_cast<double>(points.size());
  }
  /// Of some points, where the contraction moved them is the mean of what is shown, unless a circle
  /// is.
  void expectMovedToMeans() {
    const MethodSights all = sights();
    for (Eigen::Index point = 0; point < cloud->size(); point += 97) {
      const MethodSight sight = all.at(point);
      ASSERT_FALSE(sight.ball.empty());
      const Eigen::Vector3d center = sight.circle ? sight.circle->center : meanOf(sight.ball);
      EXPECT_LT((center - sight.moved).norm(), 1e-5) << point;
    }
  }
};

TEST_F(Sights, AreWhatTheContractionTakesTheMeanOf) {
  for (const char* method : {"geodesic_centroid", "adaptive_geodesic", "adaptive_sections",
                             "euclidean_ball", "one_step_laplacian", "none"}) {
    SCOPED_TRACE(method);
    options.methods["contract"] = method;
    expectMovedToMeans();
  }
}

// Of the points at one place all see what the one sees that counts.
TEST_F(Sights, AreTheSameForRepeatedPoints) {
  options.methods["contract"] = "adaptive_geodesic";
  const Eigen::Matrix3Xf plant = test::forkCloud();
  cloud = test::cloudOf(test::both(test::both(plant, plant), plant));
  const MethodSights all = sights();
  const auto densities = densitiesUsed(cloud, options, result.scale);
  ASSERT_TRUE(densities);
  for (const Eigen::Index point : {300, 3000}) {
    const MethodSight first = all.at(point);
    const MethodSight last = all.at(point + 2);
    ASSERT_FALSE(first.ball.empty());
    EXPECT_EQ(last.ball, first.ball);
    EXPECT_EQ(last.moved, first.moved);
    EXPECT_EQ((*densities)[static_cast<std::size_t>(point) + 2],
              (*densities)[static_cast<std::size_t>(point)]);
  }
}

TEST_F(Sights, FollowWhatIsSet) {
  options.methods["contract"] = "adaptive_geodesic";
  options.set("contract.along=3");
  options.set("contract.across=0.5");
  expectMovedToMeans();
  options.settings.clear();
  options.methods["contract"] = "geodesic_centroid";
  options.set("contract.circles=yes");
  expectMovedToMeans();
}

// The trunk is upright, its surface faces sideways.
TEST_F(Sights, KnowHowThePlantRuns) {
  options.set("contract.radius=0.2");
  const MethodSights all = sights();
  const Eigen::Vector3f side = (Eigen::Vector3d(500.04, 600, 701) - cloud->origin()).cast<float>();
  const MethodSight sight = all.at(nearestPoint(cloud->positions(), side));
  EXPECT_GT(std::abs(sight.direction.z()), 0.95);
  EXPECT_GT(sight.linearity, 0.5);
  EXPECT_GT(std::abs(sight.normal.x()), 0.9);
  EXPECT_DOUBLE_EQ(sight.radius, 0.2);
  EXPECT_GE(sight.neighbors.size(), 7U);
  EXPECT_TRUE(std::ranges::is_sorted(sight.ball));
  EXPECT_TRUE(std::ranges::binary_search(sight.ball, sight.point));
  EXPECT_FALSE(sight.circle);
  EXPECT_TRUE(sight.cones.empty()) << "no points are tracked";
}

TEST_F(Sights, ShowTheDensityAndRadiusOfAdaptiveMethods) {
  options.methods["contract"] = "adaptive_geodesic";
  options.set("contract.least_radius=0.05");
  options.set("contract.most_radius=0.15");
  options.set("contract.curve=2");
  const MethodSights all = sights();
  const auto densities = densitiesUsed(cloud, options, result.scale);
  ASSERT_TRUE(densities);
  for (Eigen::Index point = 0; point < cloud->size(); point += 97) {
    const MethodSight sight = all.at(point);
    EXPECT_FLOAT_EQ(static_cast<float>(sight.density),
                    (*densities)[static_cast<std::size_t>(point)]);
    EXPECT_NEAR(sight.radius, 0.05 + 0.1 * sight.density * sight.density, 1e-6);
  }
}

TEST_F(Sights, AreNoneOfAPointThatCleaningLeavesOut) {
  Eigen::Matrix3Xf stray(3, 1);
  stray << 2, 2, 2;
  cloud = test::cloudOf(test::both(test::forkCloud(), stray));
  const MethodSights all = sights();
  const Eigen::Vector3d place(502, 602, 702);
  const MethodSight sight =
      all.at(nearestPoint(cloud->positions(), (place - cloud->origin()).cast<float>()));
  EXPECT_TRUE(sight.ball.empty());
  EXPECT_LT((sight.moved - place).norm(), 1e-4);
}

TEST_F(Sights, ShowTheConesOfTheTrackerAtTheNearestNode) {
  options.methods["skeleton"] = "point_tracking";
  options.set("skeleton.cone_angle=45");
  const MethodSights all = sights();
  const Eigen::Vector3f middle = (Eigen::Vector3d(500, 600, 701) - cloud->origin()).cast<float>();
  const Eigen::Index point = nearestPoint(cloud->positions(), middle);
  const std::vector<SightCone> cones = all.at(point, *result.skeleton).cones;
  ASSERT_EQ(cones.size(), 9U) << "one ahead, 8 at 45 degrees to it";
  EXPECT_GT(cones.front().direction.z(), 0.9) << "ahead is up the trunk";
  for (const SightCone& cone : cones) {
    EXPECT_EQ(cone.apex, cones.front().apex);
    EXPECT_NEAR(cone.angle, std::numbers::pi / 4, 1e-12);
    EXPECT_GE(cone.length, 3 * 5 * result.scale.spacing - 1e-9) << "3 steps of 5 spacings or more";
    EXPECT_LE(cone.length, 3 * 6 * result.scale.spacing + 1e-9);
    EXPECT_NEAR(cone.direction.norm(), 1, 1e-9);
  }
  for (std::size_t i = 1; i < cones.size(); ++i)
    EXPECT_NEAR(cones[i].direction.dot(cones.front().direction), std::sqrt(0.5), 1e-9);
  EXPECT_TRUE(all.at(point).cones.empty()) << "without a skeleton there is no node";
}

TEST(DensitiesUsed, AreOfContractionsThatFollowThem) {
  const auto cloud = test::cloudOf(test::forkCloud());
  const PlantScale scale = Pipeline().run(cloud, {}, {}, "clean").scale;
  PipelineOptions options;
  EXPECT_FALSE(densitiesUsed(cloud, options, scale));
  options.methods["contract"] = "adaptive_sections";
  options.leftOut = PointSet::firstOf(3);
  const auto densities = densitiesUsed(cloud, options, scale);
  ASSERT_TRUE(densities);
  ASSERT_EQ(densities->size(), static_cast<std::size_t>(cloud->size()));
  EXPECT_TRUE(std::isnan((*densities)[2]));
  for (std::size_t i = 3; i < densities->size(); ++i)
    EXPECT_TRUE((*densities)[i] >= 0 && (*densities)[i] <= 1);
}

} // namespace
} // namespace espalier
