#include "tests/ui/view/pictures.h"
#include "tests/ui/view/stick_view.h"
#include "ui/view/palette.h"

#include <gmock/gmock.h>
#include <memory>
#include <vector>

namespace espalier {
namespace {

const Color lines = palette(false).reference;

/// The stick, and another state of it one to the right.
class StatesTest : public test::StickView {
protected:
  StatesTest() {
    Camera camera = view_.camera();
    camera.face(StandardView::front);
    camera.distance *= 1.5;
    view_.setCamera(camera);
    state_.skeleton = moved({1, 0, 0});
    state_.name = "moved";
  }

  [[nodiscard]] Skeleton moved(const Eigen::Vector3d& by) const {
    Skeleton skeleton = plant_;
    for (const NodeId id : skeleton.ids())
      skeleton.setPosition(id, skeleton[id].position + by);
    return skeleton;
  }
  [[nodiscard]] int count(const Eigen::Vector3d& place, const Color& color) {
    return test::countPixels(view_.picture(view_.size()), pixelOf(place), 4, color, 24);
  }
  void press(Qt::Key key) {
    auto* divider = view_.findChild<QWidget*>("divider");
    ASSERT_NE(divider, nullptr);
    QTest::keyClick(divider, key);
  }

  PlantState state_;
};

TEST_F(StatesTest, ShowsAnotherStateInPlaceOfThePlant) {
  view_.setState(Side::right, state_);
  EXPECT_GT(count({0, 0, 1.5}, test::black), 0) << "at first, all is the left side";
  EXPECT_EQ(count({1, 0, 1.5}, test::accent), 0);
  view_.setDivider(0);
  EXPECT_EQ(count({0, 0, 1.5}, test::black), 0);
  EXPECT_GT(count({1, 0, 1.5}, test::accent), 0);
  view_.setState(Side::right, std::nullopt);
  EXPECT_GT(count({0, 0, 1.5}, test::black), 0) << "the plant itself is on the right now";
}

TEST_F(StatesTest, DividesTheViewBetweenTwoStates) {
  state_.skeleton = plant_;
  view_.setState(Side::right, state_);
  const double x = pixelOf(NodeId{2}).x() / view_.width();
  view_.setDivider(x - 0.1);
  EXPECT_GT(count({0, 0, 1.5}, test::accent), 0);
  view_.setDivider(x + 0.1);
  EXPECT_EQ(count({0, 0, 1.5}, test::accent), 0);
  EXPECT_GT(count({0, 0, 1.5}, test::black), 0);
}

TEST_F(StatesTest, ShowsAStateInABallAndThePlantAroundIt) {
  state_.within = Ball{{0.5, 0, 4}, 1.2};
  view_.setState(Side::left, state_);
  EXPECT_EQ(count({0, 0, 3.7}, test::black), 0) << "in the ball";
  EXPECT_GT(count({1, 0, 3.7}, test::accent), 0);
  EXPECT_GT(count({0, 0, 0.5}, test::black), 0) << "outside of it";
}

TEST_F(StatesTest, PicksNothingThatItDoesNotShow) {
  const QPointF place = pixelOf(NodeId{2});
  const QPolygonF all(QRectF(0, 0, 400, 300));
  view_.setState(Side::left, state_);
  EXPECT_FALSE(view_.pick(place).node);
  EXPECT_THAT(view_.nodesInside(all, Depth::through), testing::IsEmpty());
  state_.within = Ball{{0, 0, 4}, 0.5};
  view_.setState(Side::left, state_);
  EXPECT_EQ(view_.pick(place).node, NodeId{2});
  EXPECT_FALSE(view_.pick(pixelOf(NodeId{4})).node);
  EXPECT_EQ(view_.nodesInside(all, Depth::through).size(), 4U);
  view_.setState(Side::left, std::nullopt);
  EXPECT_EQ(view_.pick(pixelOf(NodeId{4})).node, NodeId{4});
}

TEST_F(StatesTest, MovesTheDividerByMouseAndKeys) {
  view_.setState(Side::right, state_);
  EXPECT_EQ(view_.findChild<QWidget*>("divider"), nullptr) << "nothing is divided";
  view_.setDivider(0.5);
  std::vector<double> moves;
  QObject::connect(&view_, &PlantView::dividerMoved, [&](double at) { moves.push_back(at); });
  auto* divider = view_.findChild<QWidget*>("divider");
  ASSERT_TRUE(divider != nullptr && divider->isVisible());
  const QPoint grip = divider->rect().center();
  QTest::mousePress(divider, Qt::LeftButton, {}, grip);
  const QPoint to = grip - QPoint(100, 0);
  QMouseEvent move(QEvent::MouseMove, to, divider->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QCoreApplication::sendEvent(divider, &move);
  EXPECT_NEAR(view_.divider(), 0.25, 0.01);
  press(Qt::Key_Right);
  EXPECT_NEAR(view_.divider(), 0.27, 0.01);
  EXPECT_EQ(moves.size(), 2U);
  view_.setDivider(0);
  EXPECT_FALSE(divider->isVisible());
}

TEST_F(StatesTest, EachViewIsDividedByItself) {
  QWidget window;
  auto* first = new PlantView(&window);
  auto* second = new PlantView(*first, &window);
  second->setDivider(0);
  EXPECT_EQ(first->divider(), 1);
  EXPECT_EQ(second->divider(), 0);
}

/// A block of points that go up by two.
class BlendTest : public test::StickView {
protected:
  BlendTest() : cloud_(test::block({0, 0, 0})) {
    view_.setSkeleton({});
    view_.setCloud(cloud_);
    view_.setPointColor(PointColor::uniform);
    auto up = std::make_shared<Eigen::Matrix3Xf>(cloud_->positions());
    up->row(2).array() += 2;
    view_.setContracted(up);
    view_.frameAll();
    view_.setCamera(view_.camera()); // at once
  }
  [[nodiscard]] int countAt(double z, const Color& color, int tolerance = 90) {
    return test::countPixels(view_.picture(view_.size()), pixelOf({0, 0, z}), 6, color, tolerance);
  }

  std::shared_ptr<const PointCloud> cloud_;
};

TEST_F(BlendTest, DrawsPointsBetweenTheirEnds) {
  view_.setLayerVisible(Layer::contracted, false);
  const Color grey = palette(false).point;
  view_.setBlend(0);
  EXPECT_GT(countAt(0, grey), 50);
  EXPECT_EQ(countAt(2, grey), 0);
  view_.setBlend(0.5);
  EXPECT_GT(countAt(1, grey), 50);
  EXPECT_EQ(countAt(2, grey), 0);
  view_.setBlend(1);
  EXPECT_GT(countAt(2, grey), 50);
  EXPECT_EQ(countAt(0, grey), 0) << "in place of the points where they were scanned";
  view_.setBlend(std::nullopt);
  EXPECT_GT(countAt(0, grey), 50);
  EXPECT_EQ(countAt(2, grey), 0) << "the layer is hidden";
}

TEST_F(BlendTest, ShowsContractedPointsInPlaceOfThoseScanned) {
  view_.setLayerVisible(Layer::contracted, false);
  const Color grey = palette(false).point;
  PlantState state;
  auto up = std::make_shared<Eigen::Matrix3Xf>(cloud_->positions());
  up->row(2).array() += 2;
  state.contracted = up;
  view_.setState(Side::left, state);
  EXPECT_GT(countAt(0, grey), 50) << "of which nothing is shown: its layer is hidden";
  EXPECT_EQ(countAt(2, test::accent), 0);
  state.replacesPoints = true;
  view_.setState(Side::left, state);
  EXPECT_EQ(countAt(0, grey), 0);
  EXPECT_GT(countAt(2, test::paleAccent, 30), 50) << "so that its lines stand out";
  EXPECT_EQ(countAt(2, test::accent, 30), 0);
  state.within = Ball{{0, 0, 0}, 0.3};
  view_.setState(Side::left, state);
  EXPECT_GT(countAt(2, test::paleAccent, 30), 50);
  view_.setDivider(0);
  EXPECT_GT(countAt(0, grey), 50) << "on the other side all is as usual";
  EXPECT_EQ(countAt(2, test::paleAccent, 30), 0);
}

TEST_F(BlendTest, PicksPointsWhereTheyAreDrawn) {
  view_.setContracted(nullptr);
  const QPointF below = pixelOf({0, 0, 0});
  const QPointF above = pixelOf({0, 0, 2});
  PlantState state;
  auto up = std::make_shared<Eigen::Matrix3Xf>(cloud_->positions());
  up->row(2).array() += 2;
  state.contracted = up;
  view_.setState(Side::left, state);
  EXPECT_TRUE(view_.pick(below).point);
  EXPECT_FALSE(view_.pick(below).isOfOther);
  state.replacesPoints = true;
  view_.setState(Side::left, state);
  EXPECT_FALSE(view_.pick(below).point) << "of the points that were scanned none is drawn";
  ASSERT_TRUE(view_.pick(above).point);
  EXPECT_GT(view_.pick(above).point->z(), 1.4);
  EXPECT_TRUE(view_.pick(above).isOfOther);
  state.within = Ball{{9, 0, 0}, 0.3};
  view_.setState(Side::left, state);
  EXPECT_TRUE(view_.pick(below).point) << "outside the ball all is as usual";
}

TEST_F(BlendTest, ShowsSelectedPointsInPreviews) {
  const Color amber = palette(false).selected;
  auto states = std::make_shared<std::vector<PointState>>(static_cast<std::size_t>(cloud_->size()),
                                                          PointState::selected);
  view_.setPointStates(states);
  PlantState state;
  auto up = std::make_shared<Eigen::Matrix3Xf>(cloud_->positions());
  up->row(2).array() += 2;
  state.contracted = up;
  state.replacesPoints = true;
  view_.setState(Side::left, state);
  EXPECT_GT(countAt(2, amber), 50);
  EXPECT_EQ(countAt(2, test::accent), 0);
  state.scanned = std::make_shared<const Eigen::Matrix3Xf>(cloud_->positions().leftCols(30000));
  state.contracted = std::make_shared<const Eigen::Matrix3Xf>(up->leftCols(30000));
  for (Eigen::Index i = 0; i < 30000; ++i)
    state.points.push_back(i);
  view_.setState(Side::left, state);
  EXPECT_GT(countAt(2, amber), 50) << "in a part of the cloud, too";
  view_.setPointStates(nullptr);
  EXPECT_EQ(countAt(2, amber), 0);
}

TEST_F(BlendTest, IsOnPaperWithoutWhatOnlyTheScreenNeeds) {
  view_.setDark(true);
  view_.setPointColor(PointColor::height);
  view_.setLayerVisible(Layer::contracted, false);
  PlantState state;
  state.contracted = std::make_shared<const Eigen::Matrix3Xf>(cloud_->positions());
  const QImage paper = view_.paperOf(state, {200, 200}, PlantView::Framing::whole);
  EXPECT_GT(qGray(paper.pixel(3, 3)), 220) << "light ground";
  EXPECT_GT(test::countPixels(paper, test::accent, 40), 500);
  state.contracted = nullptr;
  const QImage scanned = view_.paperOf(state, {200, 200}, PlantView::Framing::whole);
  EXPECT_GT(test::countPixels(scanned, palette(false).point, 60), 500)
      << "not by height, for which there is no key";
}

TEST_F(BlendTest, DrawsTheDisplacements) {
  view_.setLayerVisible(Layer::points, false);
  view_.setLayerVisible(Layer::contracted, false);
  EXPECT_EQ(countAt(1, lines), 0);
  view_.setDisplacementsShown(true);
  EXPECT_GT(countAt(1, lines), 50);
  view_.setDisplacementsShown(false);
  EXPECT_EQ(countAt(1, lines), 0);
}

TEST_F(BlendTest, DrawsAPartBetweenItsEnds) {
  PlantState state;
  state.scanned = std::make_shared<const Eigen::Matrix3Xf>(cloud_->positions().leftCols(20000));
  auto up = std::make_shared<Eigen::Matrix3Xf>(*state.scanned);
  up->row(2).array() += 1;
  state.contracted = up;
  view_.setState(Side::left, state);
  view_.setLayerVisible(Layer::points, false);
  view_.setBlend(0);
  EXPECT_GT(countAt(0, test::accent), 50);
  EXPECT_EQ(countAt(1, test::accent), 0);
  view_.setBlend(1);
  EXPECT_GT(countAt(1, test::accent), 50);
}

} // namespace
} // namespace espalier
