#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/area.h"
#include "ui/view/visibility.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

using Places = std::vector<Eigen::Vector3d>;

const Eigen::Vector2d screenSize(800, 600);

/// An eye at (0, -12, 0) that looks along y: about 80 pixels a unit in the plane y = 0.
ScreenMap screenMap(Projection projection = Projection::perspective, double distance = 12) {
  Camera camera;
  camera.distance = distance;
  camera.projection = projection;
  return {camera, screenSize};
}

/// Points 0.02 apart on a wall across the line of sight.
Places wall(double y, double halfWidth, double step = 0.02) {
  Places places;
  for (double x = -halfWidth; x <= halfWidth; x += step)
    for (double z = -halfWidth; z <= halfWidth; z += step)
      places.emplace_back(x, y, z);
  return places;
}

/// Points 0.02 apart on the bark of an upright trunk of radius 0.2.
Places trunk() {
  Places places;
  for (double z = -1; z <= 1; z += 0.02)
    for (double angle = 0; angle < 2 * std::numbers::pi; angle += 0.1)
      places.emplace_back(0.2 * std::cos(angle), 0.2 * std::sin(angle), z);
  return places;
}

/// A chain of nodes from place to place, all of one radius.
Skeleton chain(const Places& places, double radius) {
  Skeleton plant;
  std::optional<NodeId> last;
  for (const Eigen::Vector3d& place : places)
    last = plant.add({.position = place, .radius = radius, .parent = last});
  return plant;
}

Scene sceneOf(const Places& points, const Skeleton& plant) {
  Scene scene;
  scene.setCloud(points.empty() ? nullptr : test::cloudOf(points));
  scene.setSkeleton(plant);
  return scene;
}

const QPolygonF everything{QRectF(0, 0, 800, 600)};

std::vector<NodeId> seenNodes(const Scene& scene, const ScreenMap& map = screenMap()) {
  return nodesInside(scene, map, everything, Depth::front);
}

TEST(Visibility, HidesNodesBehindAWallAndNoneBeforeIt) {
  const Scene scene = sceneOf(wall(0, 1), chain({{0, -1, 0}, {0, 1, 0}, {3, 1, 0}}, 0.05));
  for (const Projection projection : {Projection::perspective, Projection::parallel}) {
    const ScreenMap map = screenMap(projection);
    EXPECT_THAT(seenNodes(scene, map), testing::ElementsAre(NodeId{0}, NodeId{2}));
    EXPECT_EQ(nodesInside(scene, map, everything, Depth::through).size(), 3U);
  }
}

TEST(Visibility, DoesNotHideANodeInItsOwnWood) {
  for (const double radius : {0.2, 0.15, 0.0}) { // as measured, a fourth too small, not measured
    const Scene scene = sceneOf(trunk(), chain({{0, 0, -0.5}, {0, 0, 0}, {0, 0, 0.5}}, radius));
    EXPECT_EQ(seenNodes(scene).size(), 3U) << radius;
  }
}

TEST(Visibility, HidesATwigBehindATrunk) {
  for (const double radius : {0.01, 0.0}) {
    Places points = trunk();
    for (const double z : {0.0, 0.5})
      points.emplace_back(0, 1.01, z); // the twig's own bark
    const Scene scene = sceneOf(points, chain({{0, 1, 0}, {0, 1, 0.5}}, radius));
    EXPECT_THAT(seenNodes(scene), testing::IsEmpty()) << radius;
  }
}

// Seen along its axis wood reaches farther toward the eye than its radius.
TEST(Visibility, DoesNotHideANodeInWoodSeenAtASlant) {
  Places bark;
  for (const Eigen::Vector3d& place : trunk())
    bark.emplace_back(place.x(), place.y() * 0.707 + place.z() * 0.707,
                      place.z() * 0.707 - place.y() * 0.707);
  const Scene scene = sceneOf(bark, chain({{0, -0.3, -0.3}, {0, 0, 0}, {0, 0.3, 0.3}}, 0.2));
  EXPECT_EQ(seenNodes(scene).size(), 3U);
}

TEST(Visibility, HidesNothingBehindASingleStrayPointOrAThinTwig) {
  Places points = {{0, -1, 0}};
  for (double x = -1; x < 1; x += 0.002)
    points.emplace_back(x, -1, 0); // a line one point thick
  const Scene scene = sceneOf(points, chain({{0, 1, 0}}, 0.01));
  EXPECT_EQ(seenNodes(scene).size(), 1U);
}

// From close by the points of the wall are 12 pixels apart.
TEST(Visibility, SeesNoHolesInAWallFromCloseBy) {
  const Scene scene = sceneOf(wall(0, 1), chain({{0.01, 0.4, 0.01}}, 0.01));
  EXPECT_THAT(seenNodes(scene, screenMap(Projection::perspective, 1.5)), testing::IsEmpty());
}

TEST(Visibility, HidesNothingOfTheFocusBehindWhatIsDrawnBehindIt) {
  Scene scene = sceneOf(wall(-6, 1), chain({{0, 0, 0}, {0, 0, 1}}, 0.05));
  EXPECT_TRUE(seenNodes(scene).empty());
  scene.setFocus(
      Focus{.box = {Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)}, .branch = {}});
  EXPECT_EQ(seenNodes(scene).size(), 2U);
  scene.focusFade = 0;
  EXPECT_TRUE(seenNodes(scene).empty());
}

TEST(Visibility, HidesBehindNothingThatIsNotDrawn) {
  Scene scene = sceneOf(wall(0, 1), chain({{0, 1, 0}}, 0.05));
  scene.points.visible = false;
  EXPECT_EQ(seenNodes(scene).size(), 1U);
}

TEST(Visibility, HidesBehindEdgesDrawnWithTheirRadius) {
  Skeleton plant = chain({{0, 0, -1}, {0, 0, 1}}, 0.3);
  const NodeId behind = plant.add({.position = {0, 2, 0}, .radius = 0.05});
  Scene scene = sceneOf({}, plant);
  EXPECT_THAT(seenNodes(scene), testing::Contains(behind));
  scene.showRadii = true;
  EXPECT_THAT(seenNodes(scene), testing::ElementsAre(NodeId{0}, NodeId{1}));
}

TEST(Visibility, TakesThePointsInFront) {
  Places points = wall(0, 0.5);
  const std::size_t inFront = points.size();
  for (const Eigen::Vector3d& place : wall(1, 0.5))
    points.push_back(place);
  const Scene scene = sceneOf(points, {});
  const QPolygonF middle{QRectF(390, 290, 20, 20)}; // both walls are larger
  const auto front = pointsInside(scene, screenMap(), middle, Depth::front);
  const auto all = pointsInside(scene, screenMap(), middle, Depth::through);
  ASSERT_FALSE(front.empty());
  for (const Eigen::Index i : front)
    EXPECT_NEAR(scene.cloud->position(i).y(), 0, 1e-6);
  EXPECT_GT(all.size(), front.size());
  EXPECT_EQ(std::ranges::count_if(
                all, [&](Eigen::Index i) { return scene.cloud->position(i).y() < 0.5; }),
            std::ptrdiff_t(front.size()));
  EXPECT_EQ(pointsInside(scene, screenMap(), everything, Depth::front).size(), inFront);
}

} // namespace
} // namespace espalier
