#include "tests/support/plants.h"
#include "ui/view/skeleton_picker.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const Eigen::Vector2d pickedScreen(800, 600);
constexpr double reach = 10;

/// Looks along y at a plant whose middle is `focus`.
ScreenMap lookAt(const Eigen::Vector3d& focus, Projection projection = Projection::perspective) {
  Camera camera;
  camera.focus = focus;
  camera.distance = 12;
  camera.projection = projection;
  return {camera, pickedScreen};
}

Pick pickAt(const Skeleton& plant, const ScreenMap& map, const Eigen::Vector2d& pixel) {
  SkeletonGlyphs glyphs;
  glyphs.rebuild(plant, {0, 0, 0});
  return pickSkeleton(glyphs, map, pixel, reach);
}

TEST(SkeletonPicker, FindsEachNodeWhereItIsDrawn) {
  const Skeleton plant = test::stick(5);
  const ScreenMap map = lookAt({0, 0, 2});
  for (const NodeId id : plant.ids()) {
    const Eigen::Vector2d pixel = map.project(plant[id].position).value().pixel;
    EXPECT_EQ(pickAt(plant, map, pixel + Eigen::Vector2d(5, 5)).node, id);
  }
}

TEST(SkeletonPicker, FindsThePlaceOnAnEdge) {
  Skeleton plant;
  const NodeId root = plant.add({.position = {-2, -4, 0}});
  const NodeId child = plant.add({.position = {2, 5, 1}, .parent = root});
  for (const Projection projection : {Projection::perspective, Projection::parallel}) {
    const ScreenMap map = lookAt({0, 0, 0}, projection);
    const Eigen::Vector3d place =
        plant[root].position + 0.3 * (plant[child].position - plant[root].position);
    const Pick pick = pickAt(plant, map, map.project(place).value().pixel);
    ASSERT_TRUE(pick.edge);
    EXPECT_EQ(pick.edge->child, child);
    EXPECT_NEAR(pick.edge->fraction, 0.3, 1e-6);
    EXPECT_LT((pick.edge->position - place).norm(), 1e-5);
    EXPECT_FALSE(pick.node);
  }
}

TEST(SkeletonPicker, TakesTheFrontOneOfNodesBehindEachOther) {
  Skeleton plant;
  plant.add({.position = {0, 3, 0}});
  const NodeId front = plant.add({.position = {0, -3, 0}});
  plant.add({.position = {0, 1, 0}});
  EXPECT_EQ(pickAt(plant, lookAt({0, 0, 0}), {400, 300}).node, front);
}

TEST(SkeletonPicker, TakesANodeRatherThanItsEdges) {
  const Skeleton plant = test::fork(3);
  const ScreenMap map = lookAt({0, 0, 1});
  const Eigen::Vector2d fork = map.project(plant[test::forkTop].position).value().pixel;
  const Pick pick = pickAt(plant, map, fork + Eigen::Vector2d(0, 6));
  EXPECT_EQ(pick.node, test::forkTop);
  EXPECT_FALSE(pick.edge);
}

TEST(SkeletonPicker, FindsNothingBeyondItsReachOrBehindTheEye) {
  Skeleton plant;
  plant.add({.position = {0, -100, 0}});
  const NodeId seen = plant.add({.position = {0, 0, 0}});
  const ScreenMap map = lookAt({0, 0, 0});
  EXPECT_EQ(pickAt(plant, map, {400, 300}).node, seen);
  const Pick pick = pickAt(plant, map, {411, 300});
  EXPECT_FALSE(pick.node || pick.edge || pick.point);
}

TEST(SkeletonPicker, FindsNothingInAnEmptySkeleton) {
  EXPECT_FALSE(pickAt(Skeleton(), lookAt({0, 0, 0}), {400, 300}).node);
}

} // namespace
} // namespace espalier
