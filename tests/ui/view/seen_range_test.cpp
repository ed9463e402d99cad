#include "tests/ui/view/pictures.h"
#include "ui/view/seen_range.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A rod of 1000 points from 0 to 10 along z, seen from the front.
struct Rod {
  Scene scene;
  Rod() {
    std::vector<Vector3d> places;
    for (int i = 0; i < 1000; ++i)
      places.emplace_back(0, 0, 0.01 * i);
    scene.setCloud(test::cloudOf(places));
  }
  /// @param height of what the screen shows, its middle at 5
  [[nodiscard]] std::optional<ValueRange> seen(double height) const {
    Camera camera;
    camera.focus = {0, 0, 5};
    camera.distance = height / 2 / std::tan(Camera::fieldOfView / 2);
    return seenRange(scene, ScreenMap(camera, {400, 300}));
  }
};

TEST(SeenRange, IsThatOfThePointsCloseUp) {
  const auto seen = Rod().seen(2);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->from, 4, 0.05);
  EXPECT_NEAR(seen->to, 6, 0.05);
}

TEST(SeenRange, IsNoneOfMostOfThePlantNorWhereNothingIsSeen) {
  EXPECT_FALSE(Rod().seen(12));
  EXPECT_FALSE(Rod().seen(8));
  Rod rod;
  rod.scene.setPointColor(PointColor::uniform);
  EXPECT_FALSE(rod.seen(2)) << "they are not colored by a value";
  rod.scene.setPointColor(PointColor::height);
  rod.scene.points.visible = false;
  EXPECT_FALSE(rod.seen(2));
}

TEST(SeenRange, LeavesOutWhatIsHiddenAndOutOfFocus) {
  Rod rod;
  auto states = std::make_shared<std::vector<PointState>>(1000, PointState::hidden);
  for (std::size_t i = 400; i < 500; ++i)
    (*states)[i] = PointState::normal;
  rod.scene.setPointStates(states);
  EXPECT_NEAR(rod.seen(4)->to, 5, 0.05);
  rod.scene.setPointStates(nullptr);
  rod.scene.setFocus(Focus{.box = {Vector3d(-1, 4, 4), Vector3d(1, 5, 6)}, .branch = {}});
  EXPECT_FALSE(rod.seen(2)) << "all of it is far before the focus";
}

TEST(SeenRange, GivesWayToARangeThatWasChosenByHand) {
  Rod rod;
  rod.scene.setSeenRange(ValueRange{4, 6});
  EXPECT_EQ(rod.scene.pointLegend()->from, 4);
  ColorScales scales;
  scales.ranges["color_height"] = {1, 9};
  rod.scene.setColorScales(scales);
  EXPECT_EQ(rod.scene.pointLegend()->from, 1);
  rod.scene.setPointColor(PointColor::height);
  EXPECT_FALSE(rod.scene.seenRange) << "it is to be found anew";
}

} // namespace
} // namespace espalier
