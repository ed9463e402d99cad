#include "ui/view/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

const Eigen::Vector2d screen(800, 600);
const Eigen::Vector3d somewhere(3, -2, 5);
const Eigen::AlignedBox3d box(Eigen::Vector3d(1, -4, 2), Eigen::Vector3d(5, 0, 9));

Camera aCamera(Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.yaw = 0.7;
  camera.pitch = 0.4;
  camera.frame(box, 800.0 / 600);
  return camera;
}

class CameraIn : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(Projections, CameraIn,
                         testing::Values(Projection::perspective, Projection::parallel));

Eigen::Vector2d pixelAt(const Camera& camera, const Eigen::Vector3d& place) {
  return ScreenMap(camera, screen).project(place).value().pixel;
}

TEST_P(CameraIn, KeepsThePivotWhereItIsOnTheScreenWhenItTurns) {
  Camera camera = aCamera(GetParam());
  camera.pivot = somewhere;
  const Eigen::Vector2d before = pixelAt(camera, somewhere);
  camera.turn(1.3, -0.8);
  EXPECT_LT((pixelAt(camera, somewhere) - before).norm(), 1e-9);
}

TEST_P(CameraIn, KeepsTheAnchorWhereItIsOnTheScreenWhenItZooms) {
  Camera camera = aCamera(GetParam());
  const Eigen::Vector2d before = pixelAt(camera, somewhere);
  camera.zoom(2.5, somewhere);
  EXPECT_LT((pixelAt(camera, somewhere) - before).norm(), 1e-9);
}

TEST_P(CameraIn, ShiftsTheFocusWithThePointerWhenItPans) {
  Camera camera = aCamera(GetParam());
  const Eigen::Vector3d held = camera.focus;
  const double pixel = camera.halfHeight() / 300;
  camera.pan(30 * pixel, -20 * pixel);
  EXPECT_LT((pixelAt(camera, held) - Eigen::Vector2d(430, 320)).norm(), 1e-9);
}

TEST_P(CameraIn, ShowsAllOfAFramedBoxAndFillsTheScreenWithIt) {
  const Camera camera = aCamera(GetParam());
  Eigen::AlignedBox2d seen;
  for (int i = 0; i < 8; ++i)
    seen.extend(pixelAt(camera, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))));
  EXPECT_TRUE(Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), screen).contains(seen));
  EXPECT_GT(seen.sizes().y(), 0.75 * screen.y());
}

TEST_P(CameraIn, SendsTheRayOfAPixelThroughWhatIsDrawnThere) {
  const ScreenMap map(aCamera(GetParam()), screen);
  const auto place = map.project(somewhere).value();
  EXPECT_LT(map.ray(place.pixel).distance(somewhere), 1e-9);
  EXPECT_LT((map.place(place.pixel, place.depth) - somewhere).norm(), 1e-9);
}

// The matrices for OpenGL and the map for the pointer are computed apart from each other.
TEST_P(CameraIn, DrawsWhereThePointerFinds) {
  const Camera camera = aCamera(GetParam());
  const Eigen::Vector3d origin(100, 200, 300);
  const DepthRange depths{0.1, 100};
  const Eigen::Vector4d clip = camera.projectionMatrix(screen.x() / screen.y(), depths) *
                               camera.viewMatrix(origin) *
                               Eigen::Vector3d(somewhere - origin).homogeneous();
  const Eigen::Vector2d pixel((1 + clip.x() / clip.w()) * screen.x() / 2,
                              (1 - clip.y() / clip.w()) * screen.y() / 2);
  EXPECT_LT((pixel - pixelAt(camera, somewhere)).norm(), 1e-9);
}

TEST_P(CameraIn, EnclosesABoxBetweenItsDepths) {
  const Camera camera = aCamera(GetParam());
  const DepthRange depths = camera.depthsOf(box);
  const ScreenMap map(camera, screen);
  for (int i = 0; i < 8; ++i) {
    const auto corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    EXPECT_GT(map.project(corner).value().depth, depths.nearest);
    EXPECT_LT(map.project(corner).value().depth, depths.farthest);
  }
}

TEST(Camera, FacesThePlantFromItsSides) {
  Camera camera;
  const auto looks = [&](StandardView view) {
    camera.face(view);
    return camera.forward();
  };
  EXPECT_TRUE(looks(StandardView::front).isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(looks(StandardView::back).isApprox(-Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(looks(StandardView::left).isApprox(Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(looks(StandardView::right).isApprox(-Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(looks(StandardView::top).isApprox(-Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(looks(StandardView::bottom).isApprox(Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(looks(StandardView::isometric).isApprox(Eigen::Vector3d(-1, 1, -1).normalized()));
}

TEST(Camera, StopsAtTheZenith) {
  Camera camera;
  camera.turn(0, 5);
  EXPECT_DOUBLE_EQ(camera.pitch, std::numbers::pi / 2);
  EXPECT_TRUE(camera.up().isApprox(Eigen::Vector3d::UnitY()));
}

TEST(Camera, SeesNothingBehindItsEye) {
  const ScreenMap map(Camera(), screen); // the eye is at (0, -1, 0)
  EXPECT_FALSE(map.project({0, -2, 0}));
}

TEST(Camera, TurnsByTheSmallerAngle) {
  Camera from;
  Camera to;
  from.yaw = 3.0;
  to.yaw = -3.0;
  EXPECT_NEAR(std::abs(between(from, to, 0.5).yaw), std::numbers::pi, 1e-12);
  EXPECT_EQ(between(from, to, 1), to);
}

TEST(Camera, ShowsASingleNode) {
  Camera camera;
  camera.frame(Eigen::AlignedBox3d(somewhere), 1);
  EXPECT_EQ(camera.focus, somewhere);
  EXPECT_GT(camera.distance, 0);
}

/// The corners of a board of this width across x and depth along y, turned about z.
std::vector<Eigen::Vector3d> board(double width, double depth, double turned) {
  std::vector<Eigen::Vector3d> places;
  const Eigen::AngleAxisd turn(turned, Eigen::Vector3d::UnitZ());
  for (const double x : {-width, width})
    for (const double y : {-depth, depth})
      for (const double z : {0.0, 1.0})
        places.emplace_back(somewhere + turn * Eigen::Vector3d(x, y, z));
  return places;
}

TEST(CameraBroadside, LooksAlongTheThinSideTurningLittle) {
  for (const double turned : {-1.2, -0.4, 0.0, 0.4, 1.2}) {
    Camera camera;
    camera.pitch = 0.3;
    camera.faceBroadside(board(5, 1, turned));
    EXPECT_NEAR(camera.yaw, turned, 1e-9);
    EXPECT_EQ(camera.pitch, 0.3);
    camera.yaw = 3;
    camera.faceBroadside(board(5, 1, turned));
    EXPECT_LE(std::abs(std::remainder(camera.yaw - 3, 2 * std::numbers::pi)),
              std::numbers::pi / 2 + 1e-9);
    EXPECT_NEAR(std::abs(std::sin(camera.yaw - turned)), 0, 1e-9);
  }
}

TEST(CameraBroadside, StaysWherePlantsAreRound) {
  Camera camera;
  camera.yaw = 0.7;
  camera.faceBroadside(board(2, 1, 0));
  EXPECT_EQ(camera.yaw, 0.7);
  camera.faceBroadside({{0, 0, 0}});
  EXPECT_EQ(camera.yaw, 0.7);
}

// Up on the screen is up in the plant, and right and forward follow it as a right hand does.
TEST(Camera, StandsAlongTheAxisThatIsUp) {
  for (const UpAxis axis : {UpAxis::x, UpAxis::y, UpAxis::z}) {
    Camera camera{.upAxis = axis};
    const Eigen::Vector3d up = Eigen::Vector3d::Unit(static_cast<int>(axis));
    camera.face(StandardView::front);
    EXPECT_LT((camera.up() - up).norm(), 1e-12);
    EXPECT_LT((camera.right().cross(camera.forward()) - up).norm(), 1e-12);
    const Eigen::Vector3d front = camera.forward();
    camera.face(StandardView::right);
    EXPECT_LT((camera.up() - up).norm(), 1e-12);
    EXPECT_NEAR(camera.forward().dot(front), 0, 1e-12);
    camera.face(StandardView::top);
    EXPECT_LT((camera.forward() + up).norm(), 1e-12) << "it looks down on the plant";
    camera.face(StandardView::front);
    camera.turn(1, 0);
    EXPECT_LT((camera.up() - up).norm(), 1e-12) << "a turntable turns about it";
  }
}

TEST(Camera, LooksAtThePicturesOfOtherProgramsAsTheyDo) {
  const Camera camera{.upAxis = UpAxis::y}; // x to the right, y up, z to the viewer
  EXPECT_LT((camera.right() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((camera.forward() + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(Camera, SeesAFlatPlantBroadsideWhicheverAxisIsUp) {
  for (const UpAxis axis : {UpAxis::x, UpAxis::y, UpAxis::z}) {
    const auto up = static_cast<int>(axis);
    Camera camera{.upAxis = axis};
    std::vector<Eigen::Vector3d> fan; // high along `up`, wide along one of the others
    for (int i = 0; i <= 10; ++i)
      for (const double side : {-1.0, 1.0})
        fan.emplace_back(i * Eigen::Vector3d::Unit(up) +
                         3 * side * Eigen::Vector3d::Unit((up + 1) % 3));
    camera.faceBroadside(fan);
    EXPECT_NEAR(std::abs(camera.forward()[(up + 2) % 3]), 1, 1e-9) << up;
  }
}

// Where a place is drawn for an eye that is aside, in half widths of the screen.
double drawnAt(const Camera& camera, const Eigen::Vector3d& place) {
  const DepthRange depths{0.1, 100};
  const Eigen::Vector4d clip = camera.projectionMatrix(1, depths) *
                               camera.viewMatrix(Eigen::Vector3d::Zero()) * place.homogeneous();
  return clip.x() / clip.w();
}

TEST(Camera, OfAnEyeAsideKeepsTheFocusAndPartsWhatIsBeforeAndBehindIt) {
  for (const Projection projection : {Projection::perspective, Projection::parallel}) {
    Camera camera{.focus = {1, 2, 3}, .distance = 10, .yaw = 0.4, .projection = projection};
    const Camera middle = camera;
    camera.aside = 0.1; // the right eye
    const Eigen::Vector3d before = camera.focus - 3 * camera.forward();
    const Eigen::Vector3d behind = camera.focus + 3 * camera.forward();
    EXPECT_NEAR(drawnAt(camera, camera.focus), drawnAt(middle, camera.focus), 1e-9);
    EXPECT_LT(drawnAt(camera, before), drawnAt(middle, before) - 0.01);
    EXPECT_GT(drawnAt(camera, behind), drawnAt(middle, behind) + 0.01);
    const Eigen::Vector3d beside = camera.focus + 2 * camera.right() + camera.up();
    EXPECT_NEAR(drawnAt(camera, beside), drawnAt(middle, beside), 1e-9) << "all of its plane";
  }
}

} // namespace
} // namespace espalier
