#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "tests/ui/view/stick_view.h"
#include "ui/view/palette.h"
#include "ui/view/plant_view.h"

#include <QTest>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <vector>

namespace espalier {
namespace {

class CanvasTest : public test::StickView {
protected:
  /// A box about the nodes, 12 pixels wider than they.
  [[nodiscard]] QPolygonF around(NodeId first, NodeId last) const {
    const QRectF box = QRectF(pixelOf(first), pixelOf(last)).normalized();
    return {box.adjusted(-12, -12, 12, 12)};
  }
  [[nodiscard]] QImage seen() { return view_.grab().toImage(); }
};

TEST_F(CanvasTest, FindsTheNodesInABox) {
  EXPECT_THAT(view_.nodesInside(around(NodeId{1}, NodeId{3}), Depth::through),
              testing::ElementsAre(NodeId{1}, NodeId{2}, NodeId{3}));
  EXPECT_THAT(view_.nodesInside({QRectF(0, 0, 40, 300)}, Depth::through), testing::IsEmpty());
  EXPECT_THAT(view_.nodesInside({}, Depth::through), testing::IsEmpty());
}

// An L about node 1 and beside node 3, whose box has node 3 in it.
TEST_F(CanvasTest, FindsTheNodesInALassoNotInItsBox) {
  const QPointF low = pixelOf(NodeId{1});
  const QPointF high = pixelOf(NodeId{3});
  const QPolygonF lasso({low + QPointF(-60, 10), low + QPointF(20, 10), low + QPointF(20, -10),
                         low + QPointF(-30, -10), high + QPointF(-30, -10),
                         high + QPointF(-60, -10)});
  EXPECT_THAT(view_.nodesInside(lasso, Depth::through), testing::ElementsAre(NodeId{1}));
}

TEST_F(CanvasTest, TakesAllThatACrossingLassoWindsAround) {
  const QPointF at = pixelOf(NodeId{2});
  const QRectF outer(at - QPointF(30, 12), at + QPointF(30, 12));
  const QRectF inner = outer.adjusted(4, 4, -4, -4);
  QPolygonF twice(outer);
  twice += QPolygonF(inner);
  EXPECT_THAT(view_.nodesInside(twice, Depth::through), testing::ElementsAre(NodeId{2}));
}

TEST_F(CanvasTest, FindsNoNodesWhileTheSkeletonIsHidden) {
  view_.setLayerVisible(Layer::skeleton, false);
  EXPECT_THAT(view_.nodesInside(around(NodeId{0}, NodeId{4}), Depth::through), testing::IsEmpty());
}

TEST_F(CanvasTest, FindsTheColumnsOfThePointsInABox) {
  const auto cloud = test::cloudOf({{0, 0, 1}, {0, 0, 3}, {0, 0.3, 1}, {1, 0, 1}});
  view_.setCloud(cloud);
  std::vector<Eigen::Index> expected; // the cloud has an order of its own
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (cloud->position(i).x() < 0.5 && cloud->position(i).z() < 2) expected.push_back(i);
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(view_.pointsInside(around(NodeId{1}, NodeId{1}), Depth::through), expected);
  view_.setLayerVisible(Layer::points, false);
  EXPECT_THAT(view_.pointsInside(around(NodeId{1}, NodeId{1}), Depth::through), testing::IsEmpty());
}

TEST_F(CanvasTest, DrawsABandAsOutlineAndFaintFill) {
  const QImage before = seen();
  view_.showBand({QRectF(20, 20, 60, 60)});
  const QImage during = seen();
  EXPECT_GT(test::countPixels(during, QPointF(20, 50), 2, test::accent), 3);
  EXPECT_NE(during.pixel(50, 50), before.pixel(50, 50));
  EXPECT_EQ(test::countPixels(during, QPointF(50, 50), 8, test::accent), 0);
  view_.showBand({});
  EXPECT_EQ(test::countDifferences(before, seen()), 0);
}

TEST_F(CanvasTest, DrawsAnOpenBandAsALine) {
  const QImage before = seen();
  view_.showBand(QPolygonF({QPointF(20, 20), QPointF(80, 20), QPointF(80, 80)}));
  const QImage during = seen();
  EXPECT_GT(test::countPixels(during, QPointF(50, 20), 2, test::accent), 3);
  EXPECT_EQ(during.pixel(70, 40), before.pixel(70, 40));
}

TEST_F(CanvasTest, DrawsAPreviewOverThePlantWithItsLabel) {
  const QImage before = seen();
  Preview preview{
      .lines = {{{-1, 0, 2}, {-1, 0, 3}}}, .nodes = {{-1, 0, 2}, {-1, 5, 3}}, .label = {}};
  view_.showPreview(preview);
  const QImage plain = seen();
  const QPointF node = view_.project({-1, 0, 2}).value();
  const QPointF line = view_.project({-1, 0, 2.5}).value();
  EXPECT_GT(test::countPixels(plain, node, 4, test::accent), 10);
  EXPECT_GT(test::countPixels(plain, line, 2, test::accent, 90), 5);
  preview.label = "Trace of 3 nodes";
  view_.showPreview(preview);
  EXPECT_GT(test::countDifferences(plain, seen()), 50);
  view_.showPreview({});
  EXPECT_EQ(test::countDifferences(before, seen()), 0);
}

TEST_F(CanvasTest, LeavesBandAndPreviewOutOfAPicture) {
  const QImage before = view_.picture({200, 150});
  view_.showBand({QRectF(20, 20, 60, 60)});
  view_.showPreview({.lines = {{{-1, 0, 2}, {-1, 0, 3}}}, .nodes = {}, .label = {}});
  EXPECT_EQ(test::countDifferences(before, view_.picture({200, 150})), 0);
}

// A block of points before the plant.
TEST_F(CanvasTest, PicksThroughWoodOnlyWhenAsked) {
  view_.setCloud(test::block({0, -1, 2}));
  EXPECT_FALSE(view_.pick(pixelOf(NodeId{2})).node);
  EXPECT_EQ(view_.pick(pixelOf(NodeId{4})).node, NodeId{4});
  const QPointF onEdge = view_.project({0, 0, 2.2}).value();
  EXPECT_FALSE(view_.pick(onEdge).edge);
  view_.setDepth(Depth::through);
  EXPECT_EQ(view_.pick(pixelOf(NodeId{2})).node, NodeId{2});
}

TEST_F(CanvasTest, GivesToolsWhatAnAreaTakes) {
  std::vector<Depth> depths;
  view_.setInputHandler([&](const ToolInput& input) {
    if (input.phase == ToolInput::Phase::press) depths.push_back(input.depth);
    return true;
  });
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::ShiftModifier, {50, 50});
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::ShiftModifier | Qt::ControlModifier, {50, 50});
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::ControlModifier, {50, 50}); // the camera's
  view_.setDepth(Depth::through);
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, {50, 50});
  EXPECT_THAT(depths, testing::ElementsAre(Depth::front, Depth::through, Depth::through));
}

} // namespace
} // namespace espalier
