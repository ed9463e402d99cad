#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/palette.h"
#include "ui/view/picture.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::block;
using test::cloudOf;
using test::countDifferences;
using test::countPixels;

constexpr QSize size(400, 300);

QPointF pixelOf(const Camera& camera, const Eigen::Vector3d& place) {
  const auto found = ScreenMap(camera, {size.width(), size.height()}).project(place).value();
  return {found.pixel.x(), found.pixel.y()};
}

Camera frontOf(const Scene& scene) {
  return cameraOf(scene, StandardView::front, 4.0 / 3);
}

QImage pictureOf(const Scene& scene) {
  return picture(scene, frontOf(scene), {}, size);
}

TEST(Picture, ShowsNodesAndEdgesWhereTheyAre) {
  const Skeleton plant = test::fork(2);
  for (const bool dark : {false, true}) {
    Scene scene;
    scene.setDark(dark);
    scene.setSkeleton(plant);
    const Camera camera = frontOf(scene);
    const QImage image = picture(scene, camera, {}, size);
    for (const NodeId id : plant.ids()) {
      const QPointF place = pixelOf(camera, plant[id].position);
      EXPECT_GE(countPixels(image, place, 6, palette(dark).successor), 6) << indexOf(id);
    }
    const Eigen::Vector3d middle = (plant[NodeId{1}].position + plant[NodeId{3}].position) / 2;
    EXPECT_GE(countPixels(image, pixelOf(camera, middle), 8, palette(dark).branching), 8);
  }
}

TEST(Picture, ShowsPointsWhereTheyAre) {
  const std::vector<Eigen::Vector3d> places{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 1}, {0.3, 0, 0.2}};
  for (const Projection projection : {Projection::perspective, Projection::parallel}) {
    Scene scene;
    scene.setCloud(cloudOf(places));
    scene.setPointColor(PointColor::uniform);
    Camera camera = frontOf(scene);
    camera.projection = projection;
    camera.zoom(0.6, scene.bounds().center()); // clear of what is written in the corners
    const QImage image = picture(scene, camera, {}, size);
    for (const Eigen::Vector3d& place : places)
      EXPECT_EQ(countPixels(image, pixelOf(camera, place), 3, palette(false).point, 2), 4);
  }
}

TEST(Picture, HidesLayersThatAreOff) {
  Scene scene;
  scene.setCloud(block({0, 0, 0}));
  scene.setPointColor(PointColor::uniform);
  scene.setSkeleton(test::fork(2));
  scene.points.visible = false;
  scene.skeletonVisible = false;
  // Nothing but scale bar and axes is left; they stand in the corners.
  const QImage image = pictureOf(scene);
  EXPECT_EQ(countPixels(image, {200, 150}, 90, palette(false).point, 60), 0);
  EXPECT_EQ(countPixels(image, {200, 150}, 90, palette(false).successor, 60), 0);
}

TEST(Picture, ShowsContractedPointsInTheAccent) {
  Scene scene;
  scene.setCloud(cloudOf({{-1, 0, 0}, {1, 0, 0}}));
  const Eigen::Matrix3Xf contracted = scene.cloud->positions() * 0.5F;
  scene.contracted.set(std::make_shared<const Eigen::Matrix3Xf>(contracted));
  const Camera camera = frontOf(scene);
  const QImage image = picture(scene, camera, {}, size);
  for (const double x : {-0.5, 0.5})
    EXPECT_EQ(countPixels(image, pixelOf(camera, {x, 0, 0}), 3, palette(false).contracted, 2), 4);
}

TEST(Picture, ShowsTheSkeletonThroughThePointsButFrustaAmongThem) {
  Scene scene;
  scene.setCloud(block({0, 0, 0}));
  scene.pointSize = 10; // closed walls
  scene.setPointColor(PointColor::uniform);
  Skeleton plant;
  const NodeId root = plant.add({.position = {0, 0, -0.4}, .radius = 0.05});
  plant.add({.position = {0, 0, 0.4}, .radius = 0.05, .parent = root});
  scene.setSkeleton(plant);
  EXPECT_GE(countPixels(pictureOf(scene), {200, 150}, 20, palette(false).successor, 60), 60);
  scene.showRadii = true;
  EXPECT_EQ(countPixels(pictureOf(scene), {200, 150}, 20, palette(false).solid, 16), 0);
  scene.points.visible = false;
  EXPECT_GE(countPixels(pictureOf(scene), {200, 150}, 20, palette(false).solid, 16), 100);
}

TEST(Picture, ShowsRadiiAtTheirSize) {
  Scene scene;
  Skeleton plant;
  const NodeId root = plant.add({.position = {0, 0, 0}, .radius = 0.1});
  plant.add({.position = {0, 0, 2}, .radius = 0.1, .parent = root});
  scene.setSkeleton(plant);
  scene.showRadii = true;
  Camera camera = frontOf(scene);
  camera.projection = Projection::parallel;
  const QImage image = picture(scene, camera, {}, size);
  const QPointF middle = pixelOf(camera, {0, 0, 1});
  int width = 0;
  for (int x = 0; x < image.width(); ++x)
    width += qGray(image.pixel(x, static_cast<int>(middle.y()))) < 200 ? 1 : 0;
  const double expected = pixelOf(camera, {0.1, 0, 1}).x() - pixelOf(camera, {-0.1, 0, 1}).x();
  EXPECT_NEAR(width, expected, 2);
}

// UTM coordinates in floats would move the points by decimeters.
TEST(Picture, IsTheSameFarFromTheOriginOfCoordinates) {
  const Eigen::Vector3d far(448'262.25, 5'411'932.5, 312.125); // exact in binary
  const auto sceneAt = [](const Eigen::Vector3d& shift) {
    Scene scene;
    scene.setCloud(block(shift));
    scene.setPointColor(PointColor::uniform);
    Skeleton plant = test::fork(3);
    for (const NodeId id : plant.ids())
      plant.setPosition(id, plant[id].position + shift);
    scene.setSkeleton(plant);
    return scene;
  };
  // A rounding of 1e-9 may still carry a pixel over an edge.
  EXPECT_LE(countDifferences(pictureOf(sceneAt({0, 0, 0})), pictureOf(sceneAt(far))), 60);
}

TEST(Picture, OfNothingIsItsBackground) {
  const QImage image = picture(Scene(), {}, {}, size);
  const Palette colors = palette(false);
  EXPECT_EQ(image.size(), size);
  EXPECT_EQ(countPixels(image, {200, 0}, 1, colors.backgroundTop, 2), 6);
  EXPECT_EQ(countPixels(image, {200, 299}, 1, colors.backgroundBottom, 2), 6);
  EXPECT_EQ(countPixels(image, colors.backgroundBottom, 25), 400 * 300);
}

TEST(Picture, OfASingleNodeAndOfCoincidentPointsIsDrawn) {
  Scene scene;
  scene.setCloud(cloudOf({{1, 2, 3}, {1, 2, 3}}));
  Skeleton plant;
  plant.add({.position = {1, 2, 3}});
  scene.setSkeleton(plant);
  EXPECT_GE(countPixels(pictureOf(scene), {200, 150}, 6, palette(false).successor), 20);
}

TEST(Picture, MarksSelectionAndHover) {
  Scene scene;
  scene.setSkeleton(test::stick(4));
  scene.skeleton.select({NodeId{1}});
  Pick pick;
  pick.node = NodeId{2};
  scene.skeleton.hover(pick);
  const Camera camera = frontOf(scene);
  const QImage image = picture(scene, camera, {}, size);
  EXPECT_GE(countPixels(image, pixelOf(camera, {0, 0, 1}), 6, palette(false).selected), 20);
  EXPECT_GE(countPixels(image, pixelOf(camera, {0, 0, 2}), 6, palette(false).hovered), 20);
}

} // namespace
} // namespace espalier
