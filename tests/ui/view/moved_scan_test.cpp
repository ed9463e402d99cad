// Another scan that is laid over the one of the plant.
#include "tests/ui/view/pictures.h"
#include "ui/view/plant_view.h"

#include <QTest>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A block of points, and another scan of the same, whose frame is 2 off.
struct MovedScanTest : testing::Test {
  PlantView view;
  ShownScan scan{.cloud = test::block({2, 0, 0}),
                 .motion = Eigen::Isometry3d(Eigen::Translation3d(-4, 0, 0))}; // beside it

  MovedScanTest() {
    view.resize(400, 300);
    view.setDark(false);
    view.setPointColor(PointColor::uniform);
    view.show();
    view.setCloud(test::block({0, 0, 0}));
    view.setMovedScan(scan);
    Camera camera = view.camera();
    camera.face(StandardView::front);
    view.setCamera(camera);
    view.frameAll();
    EXPECT_TRUE(QTest::qWaitFor([this] { return view.isStill(); }));
  }
  [[nodiscard]] QPointF at(const Vector3d& place) { return view.project(place).value(); }
  [[nodiscard]] int count(const Vector3d& place, const Color& color) {
    return test::countPixels(view.picture(view.size()), at(place), 12, color, 60);
  }
};

const Color fixedColor = palette(false).fixedScan;
const Color movedColor = palette(false).movedScan;

TEST_F(MovedScanTest, IsDrawnWhereItWasMovedEachScanInItsColor) {
  EXPECT_GT(count({0, 0, 0}, fixedColor), 200);
  EXPECT_EQ(count({0, 0, 0}, movedColor), 0);
  EXPECT_GT(count({-2, 0, 0}, movedColor), 200);
  view.setMovedScan(std::nullopt);
  EXPECT_EQ(count({0, 0, 0}, fixedColor), 0) << "the plant has its colors again";
}

TEST_F(MovedScanTest, TheScanThatIsNotMeantStepsBackBehindTheOther) {
  scan.motion = Eigen::Translation3d(-2, -1.5, 0); // before the open one
  view.setMovedScan(scan);
  EXPECT_GT(count({0, 0, 0}, movedColor), 200);
  scan.foreground = Foreground::fixed;
  view.setMovedScan(scan);
  EXPECT_GT(count({0, 0, 0}, fixedColor), 200);
  EXPECT_EQ(count({0, 0, 0}, movedColor), 0);
}

TEST_F(MovedScanTest, IsColoredByValue) {
  Legend legend{.id = "distance", .title = "Distance"};
  const auto values = std::make_shared<const std::vector<float>>(
      static_cast<std::size_t>(scan.cloud->size()), 1.0F);
  scan.values = PointValues{values, legend};
  view.setMovedScan(scan);
  EXPECT_EQ(count({-2, 0, 0}, movedColor), 0);
  EXPECT_GT(count({-2, 0, 0}, colorOf(ColorMap::viridis, 1, false)), 200);
}

TEST_F(MovedScanTest, ItsPointsArePickedWhereTheyAreDrawn) {
  const Pick pick = view.pick(at({-2, 0, 0}));
  ASSERT_TRUE(pick.movedPoint);
  EXPECT_FALSE(pick.point);
  const Vector3d place = scan.motion * scan.cloud->position(*pick.movedPoint);
  EXPECT_LT((at(place) - at({-2, 0, 0})).manhattanLength(), 12);
  EXPECT_FALSE(view.pick(at({0, 0, 0})).movedPoint);
}

TEST_F(MovedScanTest, ShowsTheTargetsOfBothScans) {
  const QImage before = view.picture(view.size());
  scan.targets = {{.number = 1, .fixed = Vector3d(0, 0, 0.8), .moved = Vector3d(2, 0, 0.8)}};
  view.setMovedScan(scan);
  EXPECT_GT(test::countPixels(view.picture(view.size()), at({0, 0, 0.8}), 10, fixedColor, 60), 10);
  EXPECT_GT(test::countPixels(view.picture(view.size()), at({-2, 0, 0.8}), 10, movedColor, 60), 10);
  EXPECT_GT(test::countDifferences(before, view.picture(view.size())), 100);
}

} // namespace
} // namespace espalier
