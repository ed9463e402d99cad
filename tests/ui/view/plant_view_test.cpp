#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/plant_view.h"

#include <QTest>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <vector>

namespace espalier {
namespace {

using Phase = ToolInput::Phase;

/// A view of a stick of five nodes, seen from the front and at rest.
class PlantViewTest : public testing::Test {
protected:
  PlantViewTest() : plant_(test::stick(5)) {
    view_.resize(400, 300);
    view_.setSkeleton(plant_);
    view_.frameAll();
    view_.show();
    rest();
  }

  /// Waits until nothing moves and all is drawn.
  void rest() {
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view_));
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  }

  [[nodiscard]] QPoint pixelOf(const Eigen::Vector3d& place) const {
    return view_.project(place).value().toPoint();
  }
  [[nodiscard]] QPoint pixelOf(NodeId id) const { return pixelOf(plant_[id].position); }

  void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to,
            Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&view_, button, modifiers, from);
    move(from + (to - from) / 2, button, modifiers);
    move(to, button, modifiers);
    QTest::mouseRelease(&view_, button, modifiers, to);
  }

  // QTest::mouseMove sends no buttons.
  void move(const QPoint& to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    QMouseEvent event(QEvent::MouseMove, to, view_.mapToGlobal(to), Qt::NoButton, button,
                      modifiers);
    QCoreApplication::sendEvent(&view_, &event);
  }

  void wheel(const QPoint& at, int delta) {
    QWheelEvent event(at, view_.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view_, &event);
  }

  /// Takes what `takes` says, and notes all.
  void listen(bool takes) {
    view_.setInputHandler([this, takes](const ToolInput& input) {
      inputs_.push_back(input);
      return takes;
    });
  }
  [[nodiscard]] std::vector<Phase> phases() const {
    std::vector<Phase> phases;
    for (const ToolInput& input : inputs_)
      phases.push_back(input.phase);
    return phases;
  }

  Skeleton plant_;
  PlantView view_;
  std::vector<ToolInput> inputs_;
};

constexpr NodeId middle{2};
const QPoint aside(60, 150); // nothing is there

TEST_F(PlantViewTest, PicksEachNodeWhereItIsDrawn) {
  for (const NodeId id : plant_.ids())
    EXPECT_EQ(view_.pick(pixelOf(id)).node, id);
  EXPECT_FALSE(view_.pick(aside).node);
}

TEST_F(PlantViewTest, PicksTheEdgeBetweenNodes) {
  const Pick pick = view_.pick(pixelOf(Eigen::Vector3d(0, 0, 1.5)));
  ASSERT_TRUE(pick.edge);
  EXPECT_EQ(pick.edge->child, middle);
  EXPECT_NEAR(pick.edge->fraction, 0.5, 0.02);
}

TEST_F(PlantViewTest, PicksTheScanPointInFront) {
  view_.setCloud(test::cloudOf({{1, -1, 2}, {1, 1, 2}}));
  const auto point = view_.pick(pixelOf(Eigen::Vector3d(1, -1, 2))).point;
  ASSERT_TRUE(point);
  EXPECT_LT((*point - Eigen::Vector3d(1, -1, 2)).norm(), 1e-6);
  view_.setLayerVisible(Layer::points, false);
  EXPECT_FALSE(view_.pick(pixelOf(Eigen::Vector3d(1, -1, 2))).point);
}

// Points that are apart on the screen have no relief.
TEST_F(PlantViewTest, ShowsInMotionWhatItShowsAtRest) {
  std::vector<Eigen::Vector3d> sheet;
  for (int x = -5; x <= 5; ++x)
    for (int z = 0; z <= 20; ++z)
      sheet.emplace_back(0.2 * x, x % 2 == 0 ? -0.5 : 0.5, 0.2 * z); // before and behind the stick
  view_.setCloud(test::cloudOf(sheet));
  for (const bool areRadiiShown : {false, true}) {
    view_.setShowRadii(areRadiiShown);
    rest();
    const QImage still = view_.grab().toImage();
    view_.setCamera(view_.camera());
    const QImage moving = view_.grab().toImage();
    EXPECT_FALSE(view_.isStill());
    EXPECT_EQ(moving, still) << "with radii: " << areRadiiShown;
  }
}

TEST_F(PlantViewTest, PicksAThingBehindStrays) {
  const Eigen::Vector3d stray(1, -1, 2);
  std::vector<Eigen::Vector3d> places = {stray, stray + Eigen::Vector3d(0.01, 0, 0)};
  for (int i = 0; i < 1000; ++i) // a wall behind them
    places.emplace_back(0.8 + 0.02 * (i % 50), 1, 1.8 + 0.02 * (i / 50));
  view_.setCloud(test::cloudOf(places));
  rest();
  const Pick before = view_.pick(pixelOf(stray));
  ASSERT_TRUE(before.point && before.pointOfThing);
  EXPECT_LT(before.point->y(), -0.9) << "as it is drawn";
  EXPECT_FLOAT_EQ(static_cast<float>(before.pointOfThing->y()), 1);
}

TEST_F(PlantViewTest, PicksTheThingUnderThePointerBehindOneBesideIt) {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 400; ++i) // a pole, and a twig that is nearer
    places.insert(places.end(), {{1, 1, 0.01 * i}, {0.8 + 0.001 * i, -1, 2}});
  view_.setCloud(test::cloudOf(places));
  rest();
  const QPointF onTwig = pixelOf({1, -1, 2});
  QPointF onPole = pixelOf({1, 1, 2});
  onPole.setY(onTwig.y() + 4);
  const Pick pick = view_.pick(onPole);
  ASSERT_TRUE(pick.point && pick.pointOfThing);
  EXPECT_FLOAT_EQ(static_cast<float>(pick.point->y()), -1);
  EXPECT_FLOAT_EQ(static_cast<float>(pick.pointOfThing->y()), 1);
}

TEST_F(PlantViewTest, PicksStraysAsAThingWhereNothingElseIs) {
  const Eigen::Vector3d stray(1, -1, 2);
  view_.setCloud(test::cloudOf({stray, {0.5, 1, 0}, {0.52, 1, 0}, {0.54, 1, 0}}));
  rest();
  const auto alone = view_.pick(pixelOf(stray)).pointOfThing;
  ASSERT_TRUE(alone);
  EXPECT_LT((*alone - stray).norm(), 1e-6);
}

// Zoomed in, the front of the plant is behind the plane of the eye, and drawn all the same.
TEST_F(PlantViewTest, PicksInParallelProjectionWhateverIsDrawn) {
  const Eigen::Vector3d place(0.1, -1, 2);
  view_.setCloud(test::cloudOf({place, {0.1, 1, 2}}));
  view_.setProjection(Projection::parallel);
  view_.setPivot({0, 0, 2});
  rest();
  for (int i = 0; i < 18; ++i)
    wheel({200, 150}, 120);
  const auto point = view_.pick(pixelOf(place)).point;
  ASSERT_TRUE(point);
  EXPECT_LT((*point - place).norm(), 1e-6);
}

TEST_F(PlantViewTest, KeepsThePlantWithinTheReachOfTheWheel) {
  for (const int delta : {120, -120}) {
    for (int i = 0; i < 500; ++i)
      wheel({200, 150}, delta);
    const QPoint bottom = pixelOf(NodeId{0});
    wheel({200, 150}, delta);
    EXPECT_EQ(pixelOf(NodeId{0}), bottom);
  }
}

TEST_F(PlantViewTest, FillsItselfWithThePlant) {
  const double height = pixelOf(NodeId{0}).y() - pixelOf(NodeId{4}).y();
  EXPECT_GT(height, 0.85 * view_.height());
  EXPECT_LT(height, view_.height());
}

TEST_F(PlantViewTest, TurnsAboutThePivotByLeftDragsOnEmptyGround) {
  view_.setPivot(plant_[NodeId{1}].position);
  rest();
  const QPoint pivot = pixelOf(NodeId{1});
  const QPoint other = pixelOf(Eigen::Vector3d(1, 0, 1));
  drag(Qt::LeftButton, aside, aside + QPoint(80, 30));
  EXPECT_EQ(pixelOf(NodeId{1}), pivot);
  EXPECT_GT((pixelOf(Eigen::Vector3d(1, 0, 1)) - other).manhattanLength(), 5);
}

TEST_F(PlantViewTest, PansByRightDrags) {
  const QPoint before = pixelOf(middle);
  drag(Qt::RightButton, aside, aside + QPoint(30, -20));
  EXPECT_LE((pixelOf(middle) - before - QPoint(30, -20)).manhattanLength(), 1);
}

TEST_F(PlantViewTest, ZoomsToThePointerByTheWheel) {
  const QPoint node = pixelOf(NodeId{1});
  const int before = pixelOf(NodeId{2}).y() - node.y();
  wheel(node, 240);
  EXPECT_LE((pixelOf(NodeId{1}) - node).manhattanLength(), 1);
  EXPECT_NEAR((pixelOf(NodeId{2}).y() - node.y()) / double(before), std::exp(0.32), 0.1);
}

TEST_F(PlantViewTest, ZoomsByMiddleDrags) {
  const int before = (pixelOf(NodeId{4}) - pixelOf(NodeId{0})).manhattanLength();
  drag(Qt::MiddleButton, aside, aside + QPoint(0, 50));
  EXPECT_LT((pixelOf(NodeId{4}) - pixelOf(NodeId{0})).manhattanLength(), before);
}

TEST_F(PlantViewTest, MakesTheDoubleClickedNodeThePivot) {
  QTest::mouseDClick(&view_, Qt::LeftButton, {}, pixelOf(NodeId{4}));
  rest();
  EXPECT_LE((pixelOf(NodeId{4}) - QPoint(200, 150)).manhattanLength(), 1);
}

TEST_F(PlantViewTest, LeavesTakenGesturesToTheHandler) {
  listen(true);
  const QPoint at = pixelOf(middle);
  drag(Qt::LeftButton, at, at + QPoint(20, 0));
  EXPECT_THAT(phases(),
              testing::ElementsAre(Phase::press, Phase::drag, Phase::drag, Phase::release));
  EXPECT_EQ(pixelOf(middle), at);
  EXPECT_EQ(inputs_.front().pick.node, middle);
  EXPECT_EQ(inputs_.front().button, Qt::LeftButton);
  EXPECT_LT(inputs_.front().ray.distance(plant_[middle].position), 0.05);
}

TEST_F(PlantViewTest, GivesTheHandlerGesturesItDidNotTakeWhileTheCameraMoves) {
  listen(false);
  const QPoint before = pixelOf(middle);
  drag(Qt::RightButton, aside, aside + QPoint(30, 0));
  EXPECT_THAT(phases(),
              testing::ElementsAre(Phase::press, Phase::drag, Phase::drag, Phase::release));
  EXPECT_NE(pixelOf(middle), before);
}

TEST_F(PlantViewTest, KeepsCtrlForTheCamera) {
  listen(true);
  const QPoint before = pixelOf(Eigen::Vector3d(1, 0, 0));
  drag(Qt::LeftButton, pixelOf(middle), pixelOf(middle) + QPoint(40, 0), Qt::ControlModifier);
  EXPECT_TRUE(inputs_.empty());
  EXPECT_NE(pixelOf(Eigen::Vector3d(1, 0, 0)), before);
}

TEST_F(PlantViewTest, CancelsTheGestureOnEscape) {
  listen(true);
  QTest::mousePress(&view_, Qt::LeftButton, {}, pixelOf(middle));
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_EQ(inputs_.back().phase, Phase::cancel);
  inputs_.clear();
  QTest::mouseRelease(&view_, Qt::LeftButton, {}, pixelOf(middle));
  EXPECT_TRUE(inputs_.empty());
}

TEST_F(PlantViewTest, CancelsTheGestureWhenTheKeyboardGoesElsewhere) {
  listen(true);
  QTest::mousePress(&view_, Qt::LeftButton, {}, pixelOf(middle));
  QFocusEvent event(QEvent::FocusOut);
  QCoreApplication::sendEvent(&view_, &event);
  EXPECT_EQ(inputs_.back().phase, Phase::cancel);
}

TEST_F(PlantViewTest, ReportsHoversAndThatThePointerHasLeft) {
  listen(false);
  move(pixelOf(middle), Qt::NoButton);
  ASSERT_FALSE(inputs_.empty());
  EXPECT_EQ(inputs_.back().phase, Phase::hover);
  EXPECT_EQ(inputs_.back().pick.node, middle);
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&view_, &leave);
  EXPECT_EQ(inputs_.back().phase, Phase::hover);
  EXPECT_FALSE(inputs_.back().pick.node);
}

TEST_F(PlantViewTest, FliesToAStandardViewAndArrives) {
  view_.look(StandardView::right);
  EXPECT_FALSE(view_.isStill());
  rest();
  // From the right, what is in front of the plant is on the left.
  EXPECT_LT(pixelOf(Eigen::Vector3d(0, -1, 2)).x(), 190);
}

TEST_F(PlantViewTest, StopsAFlightWhenTheUserTakesTheCamera) {
  view_.look(StandardView::right);
  wheel({200, 150}, 120);
  const QPoint at = pixelOf(Eigen::Vector3d(0, -1, 2));
  rest();
  EXPECT_EQ(pixelOf(Eigen::Vector3d(0, -1, 2)), at);
}

TEST_F(PlantViewTest, ShowsAnEditAsIfAllHadBeenDrawnAnew) {
  view_.setCloud(test::block({0, 0, 2}));
  rest();
  SkeletonEditor editor(plant_);
  editor.setPosition(middle, {0.5, 0, 2});
  const NodeId added = editor.add({.position = {1, 0, 3}, .parent = middle});
  editor.setEdge(added, EdgeType::branching);
  editor.erase(NodeId{4});
  const QImage before = view_.grab().toImage();
  view_.updateSkeleton(plant_, editor.commit());
  rest();
  const QImage updated = view_.grab().toImage();
  EXPECT_GT(test::countDifferences(before, updated), 50);
  view_.setSkeleton(plant_);
  rest();
  // The typical length of edges, by which discs are scaled, is taken anew.
  EXPECT_EQ(test::countDifferences(updated, view_.grab().toImage()), 0);
}

TEST_F(PlantViewTest, ShowsAllPointsAgainAfterMoving) {
  view_.setCloud(test::block({0, 0, 2}));
  view_.setPointColor(PointColor::uniform);
  rest();
  const QImage before = view_.grab().toImage();
  QTest::mousePress(&view_, Qt::LeftButton, Qt::ControlModifier, aside);
  move(aside + QPoint(40, 0), Qt::LeftButton, Qt::ControlModifier);
  EXPECT_FALSE(view_.isStill());
  move(aside, Qt::LeftButton, Qt::ControlModifier);
  QTest::mouseRelease(&view_, Qt::LeftButton, Qt::ControlModifier, aside);
  rest();
  // The turn there and back is exact to rounding only.
  EXPECT_LE(test::countDifferences(before, view_.grab().toImage()), 400 * 300 / 500);
}

TEST_F(PlantViewTest, TakesThePictureOfWhatIsShown) {
  view_.setCloud(test::block({0, 0, 2}));
  rest();
  const QImage shown = view_.grab().toImage();
  const QImage picture = view_.picture(view_.size());
  EXPECT_EQ(picture.size(), QSize(400, 300));
  EXPECT_LE(test::countDifferences(shown.convertToFormat(picture.format()), picture),
            400 * 300 / 200);
}

/// The block with one more point.
std::shared_ptr<const PointCloud> blockAnd(const Eigen::Vector3d& stray) {
  const auto block = test::block({0, 0, 2});
  std::vector<Eigen::Vector3d> positions = {stray};
  for (Eigen::Index i = 0; i < block->size(); ++i)
    positions.push_back(block->position(i));
  return test::cloudOf(positions);
}

TEST_F(PlantViewTest, FramesThePlantAndNotAPointFarAway) {
  view_.setCloud(test::block({0, 0, 2}));
  view_.frameAll();
  rest();
  const Camera camera = view_.camera();
  const Eigen::AlignedBox3d bounds = view_.bounds();
  const QImage alone = view_.grab().toImage();
  view_.setCloud(blockAnd({5e5, 5e6, 300}));
  view_.frameAll();
  rest();
  EXPECT_NEAR(view_.camera().distance, camera.distance, 1e-3 * camera.distance);
  EXPECT_LT((view_.camera().focus - camera.focus).norm(), 1e-2);
  EXPECT_TRUE(view_.bounds().isApprox(bounds, 1e-6));
  view_.setCamera(camera); // it frames a sample of the points, another one now
  rest();
  EXPECT_LT(test::countDifferences(alone, view_.grab().toImage()), 400 * 300 / 50);
}

TEST_F(PlantViewTest, ShowsAPointFarAwayFromFarAway) {
  view_.setSkeleton({});
  const Eigen::AlignedBox3d all(Eigen::Vector3d(-0.5, -0.5, 1.5), Eigen::Vector3d(60, 90, 2.5));
  const auto pictureWith = [&](std::shared_ptr<const PointCloud> cloud) {
    view_.setCloud(std::move(cloud));
    view_.setPointColor(PointColor::uniform);
    view_.frame(all);
    rest();
    return view_.grab().toImage();
  };
  const QImage alone = pictureWith(test::block({0, 0, 2}));
  const QImage beside = pictureWith(blockAnd({60, 90, 2}));
  const QPoint place = pixelOf({60, 90, 2});
  const QRect around(place - QPoint(4, 4), place + QPoint(4, 4));
  EXPECT_GT(test::countDifferences(alone.copy(around), beside.copy(around)), 0);
}

TEST_F(PlantViewTest, ShowsAnEmptyPlant) {
  view_.setCloud(nullptr);
  view_.setContracted(nullptr);
  view_.setSkeleton({});
  view_.frameAll();
  rest();
  EXPECT_FALSE(view_.pick({200, 150}).node);
  wheel({200, 150}, 120);
  drag(Qt::LeftButton, aside, aside + QPoint(30, 30));
  rest();
}

} // namespace
} // namespace espalier
