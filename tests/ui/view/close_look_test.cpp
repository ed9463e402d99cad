#include "tests/support/plants.h"
#include "ui/view/close_look.h"
#include "ui/view/scene.h"
#include "ui/view/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double quarterTurn = std::numbers::pi / 2;
const QSizeF screenSize(800, 600); // [logical pixels]

/// A shoot from the origin to `tip`, of length 1.
Skeleton shoot(const Eigen::Vector3d& tip) {
  Skeleton plant;
  const NodeId root = plant.add({.position = {0, 0, 0}, .radius = 0.01});
  plant.add({.position = tip, .radius = 0.01, .parent = root});
  return plant;
}

const Sight ofShoot{.nodes = {NodeId{0}, NodeId{1}}, .margin = 0.5};

struct CloseLookTest : testing::Test {
  Scene scene;
  Camera front; // looks along y

  void setWall(double y) { // of points, across the line of sight at y
    RawPoints raw;
    for (int i = -150; i <= 150; ++i)
      for (int k = -150; k <= 150; ++k)
        raw.positions.emplace_back(0.02 * i, y, 0.02 * k);
    scene.setCloud(std::make_shared<const PointCloud>(std::move(raw)));
  }
  [[nodiscard]] bool isSeen(const Camera& camera, std::size_t slot) const {
    const ScreenMap screen(camera, {screenSize.width(), screenSize.height()});
    const auto at = screen.project(scene.skeleton.position(slot));
    const QRectF all({}, screenSize);
    return at && all.contains(QPointF(at->pixel.x(), at->pixel.y())) &&
           !Visibility(scene, screen, all).hidesNode(slot, *at);
  }
};

TEST_F(CloseLookTest, FillsTheScreenWithWhatIsMeant) {
  scene.setSkeleton(shoot({0, 0, 1}));
  const Camera camera = cameraToSee(scene, front, ofShoot, screenSize);
  EXPECT_LT((camera.focus - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-9);
  EXPECT_EQ(camera.pivot, camera.focus);
  EXPECT_GT(camera.halfHeight(), 1.0) << "a half of it and the margin";
  EXPECT_LT(camera.halfHeight(), 1.3);
  EXPECT_TRUE(isSeen(camera, 0));
  EXPECT_TRUE(isSeen(camera, 1));
}

TEST_F(CloseLookTest, KeepsTheDirectionThatIsGoodEnough) {
  scene.setSkeleton(shoot({0, 0, 1}));
  front.yaw = 0.3;
  const Camera camera = cameraToSee(scene, front, ofShoot, screenSize);
  EXPECT_NEAR(camera.yaw, front.yaw, 1e-9);
  EXPECT_NEAR(camera.pitch, front.pitch, 1e-9);
}

TEST_F(CloseLookTest, LooksAtAShootFromItsSide) {
  scene.setSkeleton(shoot({0, 1, 0})); // away from the eye
  const Camera camera = cameraToSee(scene, front, ofShoot, screenSize);
  const double sine = camera.forward().cross(Eigen::Vector3d::UnitY()).norm();
  EXPECT_GT(sine, std::sin(quarterTurn / 2));
}

TEST_F(CloseLookTest, PartsTheLinesThatAreToBeSeenApart) {
  scene.setSkeleton(shoot({0, 0, 1}));
  Sight sight = ofShoot;
  for (const double y : {-0.2, 0.2}) // one behind the other, as seen from the front
    sight.apart.push_back({{0, y, 0}, {0, y, 1}});
  const Camera alike = cameraToSee(scene, front, ofShoot, screenSize);
  const Camera camera = cameraToSee(scene, front, sight, screenSize);
  EXPECT_GT(std::abs(alike.forward().y()), 0.9) << "without them nothing calls for a turn";
  EXPECT_LT(std::abs(camera.forward().y()), 0.5);
}

TEST_F(CloseLookTest, GoesAroundWhatStandsBeforeIt) {
  scene.setSkeleton(shoot({0, 0, 1}));
  setWall(-0.5);
  EXPECT_FALSE(isSeen(
      [&] {
        Camera camera = front;
        camera.frame(
            Eigen::AlignedBox3d(Eigen::Vector3d(-0.5, 0, -0.5), Eigen::Vector3d(0.5, 0, 1.5)),
            screenSize.width() / screenSize.height());
        return camera;
      }(),
      1));
  const Camera camera = cameraToSee(scene, front, ofShoot, screenSize);
  EXPECT_TRUE(isSeen(camera, 0));
  EXPECT_TRUE(isSeen(camera, 1));
}

TEST_F(CloseLookTest, ShowsWhatItCanOfWhatIsHiddenFromAllSides) {
  scene.setSkeleton(shoot({0, 0, 1}));
  RawPoints raw; // all over a ball about it
  for (int i = 0; i < 20'000; ++i) {
    const double height = -1 + 2 * (i + 0.5) / 20'000;
    const double angle = i * 2.399963; // the golden angle
    const double wide = std::sqrt(1 - height * height);
    raw.positions.emplace_back(0.9 * wide * std::cos(angle), 0.9 * wide * std::sin(angle),
                               0.5 + 0.9 * height);
  }
  scene.setCloud(std::make_shared<const PointCloud>(std::move(raw)));
  const Camera camera = cameraToSee(scene, front, ofShoot, screenSize);
  EXPECT_GT(camera.distance, 0);
  EXPECT_LT((camera.focus - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-9);
}

TEST_F(CloseLookTest, ShowsAPlaceOnThePoints) {
  scene.setSkeleton(shoot({0, 0, 1}));
  setWall(-0.5);
  const Sight sight{.nodes = {}, .places = {{1, -0.5, 1}}, .margin = 0.2};
  const Camera camera = cameraToSee(scene, front, sight, screenSize);
  EXPECT_LT((camera.focus - Eigen::Vector3d(1, -0.5, 1)).norm(), 1e-9);
  EXPECT_NEAR(camera.halfHeight(), 0.2 * 1.08, 0.01);
}

TEST_F(CloseLookTest, GoesAroundNothingThatAPreviewReplaces) {
  scene.setSkeleton(shoot({0, 0, 1}));
  setWall(-0.5);
  Sight sight{.nodes = {}, .places = {{0, 0, 0.5}}, .margin = 0.2};
  const Camera around = cameraToSee(scene, front, sight, screenSize);
  EXPECT_GT(std::abs(around.yaw - front.yaw) + std::abs(around.pitch - front.pitch), 0.1);
  sight.isOfOther = true;
  const Camera straight = cameraToSee(scene, front, sight, screenSize);
  EXPECT_NEAR(straight.yaw, front.yaw, 1e-9);
  EXPECT_NEAR(straight.pitch, front.pitch, 1e-9);
}

TEST_F(CloseLookTest, KeepsTheProjection) {
  scene.setSkeleton(shoot({0, 0, 1}));
  front.projection = Projection::parallel;
  EXPECT_EQ(cameraToSee(scene, front, ofShoot, screenSize).projection, Projection::parallel);
}

} // namespace
} // namespace espalier
