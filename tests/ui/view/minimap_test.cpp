#include "tests/ui/view/pictures.h"
#include "tests/ui/view/stick_view.h"
#include "ui/view/minimap.h"
#include "ui/view/palette.h"

namespace espalier {
namespace {

/// A stick along z from 0 to 4 in a view that is large enough for a map; the view shows its middle.
class MinimapTest : public test::StickView {
protected:
  MinimapTest() {
    view_.resize(800, 600);
    view_.setMinimapShown(true);
    Camera camera = view_.camera();
    camera.distance /= 4;
    camera.focus = {0, 0, 2};
    view_.setCamera(camera);
    map_ = view_.findChild<Minimap*>();
    EXPECT_TRUE(QTest::qWaitFor([&] { return isDrawn(); }));
  }
  [[nodiscard]] QImage seen() { return map_->grab().toImage(); }
  /// Are the ends of the stick on the map? It is drawn a moment after it is shown.
  [[nodiscard]] bool isDrawn() {
    const Color gray{140, 142, 142}; // a thin line of half of the black of an edge
    return test::countPixels(seen(), onMap(3.9), 2, gray, 50) > 0 &&
           test::countPixels(seen(), onMap(0.1), 2, gray, 50) > 0;
  }
  /// The stick fills the map but for the margin of a framed plant, 8 % of its height.
  [[nodiscard]] QPointF onMap(double height) const {
    const QPointF middle = QRectF(map_->rect()).center();
    return middle - QPointF(0, (height - 2) / 2 * middle.y() / 1.08);
  }
  void drag(double from, double to) {
    QTest::mousePress(map_, Qt::LeftButton, {}, onMap(from).toPoint());
    QTest::mouseMove(map_, onMap(to).toPoint());
    QTest::mouseRelease(map_, Qt::LeftButton, {}, onMap(to).toPoint());
  }

  Minimap* map_ = nullptr;
  const double pixel_ = 2 * 1.08 / 63; // [L], the map is 126 high
};

TEST_F(MinimapTest, AClickMovesTheCameraThere) {
  const Camera before = view_.camera();
  drag(3.5, 3.5);
  EXPECT_NEAR(view_.camera().focus.z(), 3.5, pixel_);
  EXPECT_EQ(view_.camera().distance, before.distance);
  EXPECT_NEAR(view_.camera().focus.y(), before.focus.y(), 1e-9) << "at the same depth";
}

TEST_F(MinimapTest, TheFrameIsDraggedByWhereItIsHeld) {
  drag(2.2, 3.2); // the frame is half of a unit high on either side
  EXPECT_NEAR(view_.camera().focus.z(), 3, 2 * pixel_);
}

TEST_F(MinimapTest, EscapeInADragPutsTheCameraBack) {
  const Camera before = view_.camera();
  QTest::mousePress(map_, Qt::LeftButton, {}, onMap(2.2).toPoint());
  QTest::mouseMove(map_, onMap(3.2).toPoint());
  EXPECT_NE(view_.camera(), before);
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_EQ(view_.camera(), before);
  QTest::mouseMove(map_, onMap(1).toPoint());
  QTest::mouseRelease(map_, Qt::LeftButton, {}, onMap(1).toPoint());
  EXPECT_EQ(view_.camera(), before) << "the drag is over";
}

TEST_F(MinimapTest, FramesWhatTheViewShows) {
  const Color accent = palette(false).contracted;
  const double top = view_.camera().halfHeight();
  const QPointF beside(10, 0); // of the stick
  EXPECT_GT(test::countPixels(seen(), onMap(2 + top) + beside, 3, accent, 60), 3);
  EXPECT_EQ(test::countPixels(seen(), onMap(2 + 2 * top) + beside, 3, accent, 60), 0);
  view_.frameAll();
  EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  EXPECT_EQ(test::countPixels(seen(), onMap(2 + top) + beside, 2, accent, 60), 0);
}

TEST_F(MinimapTest, TurnsWithTheView) {
  view_.look(StandardView::top);
  EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  EXPECT_FALSE(isDrawn()) << "from above the stick is a dot";
}

TEST_F(MinimapTest, FollowsEditsOfThePlant) {
  view_.setSkeleton(Skeleton());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !isDrawn(); }));
}

TEST_F(MinimapTest, IsAbsentInASmallViewAndWhereAllIsSeen) {
  EXPECT_TRUE(map_->isVisible());
  view_.resize(400, 600);
  EXPECT_FALSE(map_->isVisible());
  view_.resize(800, 600);
  EXPECT_TRUE(map_->isVisible());
  view_.frameAll();
  EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  EXPECT_FALSE(map_->isVisible()) << "all is seen anyway";
  view_.setMinimapShown(false);
  EXPECT_EQ(view_.findChild<Minimap*>(), nullptr);
}

} // namespace
} // namespace espalier
