#include "core/skeleton/point_distances.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/random_edits.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace espalier {
namespace {

std::shared_ptr<const PointCloud> cloudAt(std::vector<Eigen::Vector3d> places) {
  return std::make_shared<const PointCloud>(RawPoints{std::move(places), {}, {}});
}

/// Points at random in a ball about the origin.
std::shared_ptr<const PointCloud> ballOfPoints(int count, double radius, std::uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < count; ++i)
    places.push_back(random.uniform(0, radius) * random.direction());
  return cloudAt(std::move(places));
}

float surfaceOver(const Eigen::Vector3d& place, const Skeleton& plant) {
  return PointDistances(cloudAt({place}), 1, plant).toSurface().front();
}

TEST(PointDistances, GoToTheSurface) {
  const PointDistances distances(cloudAt({{3, 4, 1.5}}), 1, test::stick(3)); // radius 0.1
  EXPECT_FLOAT_EQ(distances.toSurface().front(), 4.9F);
  EXPECT_EQ(distances.nearest().front(), NodeId{2});
}

TEST(PointDistances, AreNegativeInsideTheWood) {
  EXPECT_FLOAT_EQ(surfaceOver({0.04, 0, 0.5}, test::stick(2)), -0.06F);
}

TEST(PointDistances, FollowTheRadiusFromEndToEndOfAnEdge) {
  Skeleton cone = test::stick(2);
  cone.setRadius(NodeId{0}, 0.4);
  cone.setRadius(NodeId{1}, 0.2);
  EXPECT_FLOAT_EQ(surfaceOver({1, 0, 0.5}, cone), 0.7F);
  cone.setEdge(NodeId{1}, EdgeType::branching); // a branch has its own radius all along
  EXPECT_FLOAT_EQ(surfaceOver({1, 0, 0.5}, cone), 0.8F);
}

TEST(PointDistances, FollowTheRadiusOfTheNodeWhereItsParentHasNone) {
  Skeleton stick = test::stick(2);
  stick.setRadius(NodeId{0}, 0);
  stick.setRadius(NodeId{1}, 0.2);
  EXPECT_FLOAT_EQ(surfaceOver({1, 0, 0.5}, stick), 0.8F);
}

// A thick trunk at a distance of 3 with a surface at 1, a thin twig at a distance of 2.
TEST(PointDistances, TakeTheNearestSurfaceThoughAnAxisIsNearer) {
  Skeleton plant;
  const NodeId trunk = plant.add({.position = {0, 0, 0}, .radius = 2});
  plant.add({.position = {0, 0, 9}, .radius = 2, .parent = trunk});
  const NodeId twig = plant.add({.position = {5, 0, 0}, .radius = 0});
  plant.add({.position = {5, 0, 9}, .radius = 0, .parent = twig});
  const PointDistances distances(cloudAt({{3, 0, 4}}), 1, plant);
  EXPECT_FLOAT_EQ(distances.toSurface().front(), 1);
}

TEST(PointDistances, TakeARootWithoutEdgesForABall) {
  EXPECT_FLOAT_EQ(surfaceOver({0, 2, 0}, test::stick(1)), 1.9F);
}

TEST(PointDistances, AreInfiniteWithoutNodesAndNoneWithoutPoints) {
  EXPECT_TRUE(std::isinf(surfaceOver({1, 2, 3}, {})));
  const PointDistances none(std::make_shared<const PointCloud>(), 0, test::fork(3));
  EXPECT_THAT(none.toSurface(), testing::IsEmpty());
}

TEST(PointDistances, AreWhatTryingAllEdgesFinds) {
  const Skeleton plant = test::randomPlant(300, 5);
  const auto cloud = ballOfPoints(2000, 25, 6);
  const PointDistances distances(cloud, 0.5, plant);
  for (Eigen::Index i = 0; i < cloud->size(); ++i) {
    double surface = std::numeric_limits<double>::infinity();
    for (const NodeId id : plant.ids()) {
      const auto body = frustumOf(plant, id);
      if (!body) continue;
      const NearestShares near = nearestShares(*body, {cloud->position(i), cloud->position(i)});
      surface = std::min(surface, near.distance - body->radiusAt(near.a));
    }
    const auto k = static_cast<std::size_t>(i);
    ASSERT_NEAR(distances.toSurface()[k], surface, 1e-5);
  }
}

TEST(PointDistances, DoNotDependOnTheSizeOfTheRuns) {
  const auto cloud = ballOfPoints(3000, 20, 7);
  const Skeleton plant = test::randomPlant(200, 8);
  const PointDistances wide(cloud, 2, plant);
  const PointDistances single(cloud, 0, plant);
  EXPECT_EQ(wide.toSurface(), single.toSurface());
  EXPECT_EQ(wide.nearest(), single.nearest());
}

TEST(PointDistances, AreAfterEachEditWhatTheyAreAnew) {
  const auto cloud = ballOfPoints(800, 1.5, 9);
  Random random(10);
  Skeleton plant;
  PointDistances kept(cloud, 0.1, plant);
  for (int edit = 0; edit < 600; ++edit) {
    SkeletonEditor editor(plant);
    for (std::size_t more = random.below(3); more != static_cast<std::size_t>(-1); --more)
      test::editAtRandom(editor, random);
    kept.update(plant, editor.commit());
    if (edit % 3 != 0) continue;
    const PointDistances anew(cloud, 0.1, plant);
    ASSERT_EQ(kept.toSurface(), anew.toSurface()) << "edit " << edit;
    ASSERT_EQ(kept.nearest(), anew.nearest()) << "edit " << edit;
  }
}

TEST(PointDistances, ListAllPointsThatAnEditChanged) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const auto cloud = std::make_shared<const PointCloud>(tree.cloud);
  Skeleton plant = tree.truth;
  PointDistances kept(cloud, pointSpacing(cloud->positions()), plant);
  const std::vector<float> before = kept.toSurface();
  SkeletonEditor editor(plant);
  const NodeId apex = plant.ids().back();
  editor.setPosition(apex, plant[apex].position + Eigen::Vector3d(0.05, 0, 0));
  const std::vector<Eigen::Index> changed = kept.update(plant, editor.commit());
  EXPECT_TRUE(std::ranges::is_sorted(changed));
  EXPECT_LT(changed.size(), before.size() / 10); // a twig is no reason to look at the whole plant
  for (Eigen::Index i = 0; i < cloud->size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (before[k] != kept.toSurface()[k]) {
      EXPECT_TRUE(std::ranges::binary_search(changed, i));
    }
  }
}

TEST(PointDistances, LookAtNoPointForAMarkOrAComment) {
  Skeleton plant = test::stick(4);
  PointDistances kept(ballOfPoints(100, 3, 1), 0.1, plant);
  SkeletonEditor editor(plant);
  editor.setReview(NodeId{2}, {ReviewState::doubtful, "why?", "Anna"});
  EXPECT_THAT(kept.update(plant, editor.commit()), testing::IsEmpty());
}

TEST(PointDistances, StopWhenAsked) {
  const auto cloud = ballOfPoints(3000, 5, 2);
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(PointDistances(cloud, 0.1, test::stick(5), progress));
  }));
}

} // namespace
} // namespace espalier
