#include "tests/ui/view/pictures.h"
#include "ui/view/color_bar.h"
#include "ui/view/corner.h"
#include "ui/view/minimap.h"
#include "ui/view/plant_view.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

constexpr QSizeF viewSize(800, 600);

/// Places all over a box, denser than the cells that are counted.
std::vector<QPointF> placesIn(const QRectF& box) {
  std::vector<QPointF> places;
  for (double x = box.left() + 1; x < box.right(); x += 4)
    for (double y = box.top() + 1; y < box.bottom(); y += 4)
      places.emplace_back(x, y);
  return places;
}

InCorner at(Corner corner) {
  return {{120, 220}, 8, corner};
}

QRectF placeOf(Corner corner) {
  return boxIn(corner, at(corner).box, viewSize, at(corner).margin);
}

TEST(Corners, WhatLiesOverThePlantGoesWhereItIsNot) {
  EXPECT_EQ(freestCorner(at(Corner::topRight), {}, viewSize, {}), Corner::topRight);
  for (const Corner free :
       {Corner::topRight, Corner::topLeft, Corner::bottomRight, Corner::bottomLeft}) {
    std::vector<QPointF> plant;
    for (const QPointF& place : placesIn({QPointF(0, 0), viewSize}))
      if (!placeOf(free).contains(place)) plant.push_back(place);
    for (const Corner now : {Corner::topRight, Corner::bottomLeft})
      EXPECT_EQ(freestCorner(at(now), {plant, {}}, viewSize, {}), free);
  }
}

TEST(Corners, ItStaysUnlessAnotherIsClearlyBetter) {
  const QRectF box = placeOf(Corner::topRight);
  const auto goesFrom = [&](double width, double height) { // shares of the box with plant
    const QRectF covered(box.topLeft(), QSizeF(width * box.width(), height * box.height()));
    return freestCorner(at(Corner::topRight), {placesIn(covered), {}}, viewSize, {}) !=
           Corner::topRight;
  };
  EXPECT_FALSE(goesFrom(0.2, 0.05));
  EXPECT_TRUE(goesFrom(1, 0.5));
  // All corners have plant, one of them somewhat less.
  std::vector<QPointF> plant = placesIn({QPointF(0, 0), viewSize});
  const QRectF left = placeOf(Corner::topLeft);
  std::erase_if(plant, [&](const QPointF& place) {
    return left.contains(place) && place.y() < left.top() + 0.2 * left.height();
  });
  EXPECT_EQ(freestCorner(at(Corner::topRight), {plant, {}}, viewSize, {}), Corner::topRight);
  EXPECT_EQ(freestCorner(at(Corner::topRight), {plant, {}}, viewSize, {Corner::topRight}),
            Corner::topLeft)
      << "its own is taken";
}

TEST(Corners, ItCoversThePlantRatherThanWhatIsSelected) {
  OnScreen plant{.plant = placesIn({QPointF(0, 0), viewSize}), .selected = {}};
  std::erase_if(plant.plant, [&](const QPointF& place) { // one corner is free of it
    return placeOf(Corner::topLeft).contains(place);
  });
  EXPECT_EQ(freestCorner(at(Corner::topRight), plant, viewSize, {}), Corner::topLeft);
  const QPointF middle = placeOf(Corner::topLeft).center();
  plant.selected = placesIn({middle, middle + QPointF(60, 40)});
  EXPECT_EQ(freestCorner(at(Corner::topRight), plant, viewSize, {}), Corner::topRight);
}

/// A flat plant that fills a quarter of the view, so that one corner is full of it.
class GivesWay : public testing::Test {
protected:
  GivesWay() {
    view_.resize(800, 600);
    view_.setDark(false);
    view_.setMinimapShown(true);
    std::vector<Eigen::Vector3d> places;
    for (int i = 0; i < 200; ++i)
      for (int k = 0; k < 200; ++k)
        places.emplace_back(i / 200.0, 0, k / 200.0);
    view_.setCloud(test::cloudOf(places));
    view_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view_));
  }
  /// The plant is 1 wide and high, the view somewhat more.
  void showWithItsEdgeAt(const Eigen::Vector3d& focus) {
    Camera camera = view_.camera();
    camera.face(StandardView::front);
    camera.projection = Projection::parallel;
    camera.focus = focus;
    camera.distance = 0.6 / std::tan(Camera::fieldOfView / 2); // 1.2 high, 1.6 wide
    QSignalSpy settled(&view_, &PlantView::settled);
    view_.setCamera(camera);
    EXPECT_TRUE(settled.wait());
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  }
  [[nodiscard]] QRectF plantBox() const {
    return QRectF(*view_.project({0, 0, 1}), *view_.project({1, 0, 0})).normalized();
  }
  [[nodiscard]] QRectF bar() const { return view_.findChild<ColorBar*>()->geometry(); }
  [[nodiscard]] QRectF map() const { return view_.findChild<Minimap*>()->geometry(); }

  PlantView view_;
};

TEST_F(GivesWay, ColorBarAndMinimapLeaveThePlant) {
  for (const Eigen::Vector3d& focus :
       {Eigen::Vector3d(0.2, 0, 0.2), Eigen::Vector3d(0.8, 0, 0.8), Eigen::Vector3d(0.2, 0, 0.8),
        Eigen::Vector3d(0.8, 0, 0.2)}) {
    showWithItsEdgeAt(focus); // over a corner and more of the view
    EXPECT_FALSE(plantBox().intersects(bar())) << focus.transpose();
    EXPECT_FALSE(plantBox().intersects(map())) << focus.transpose();
    EXPECT_FALSE(bar().intersects(map())) << focus.transpose();
  }
}

TEST_F(GivesWay, NothingMovesOffWhatIsBesideTheFocus) {
  showWithItsEdgeAt({0.8, 0, 0.8}); // upper right free
  const QRectF before = bar();
  Camera camera = view_.camera();
  camera.focus = {0.2, 0, 0.2};
  const auto flyThere = [&](const std::optional<Focus>& focus) {
    QSignalSpy settled(&view_, &PlantView::settled);
    view_.flyTo(camera, focus);
    EXPECT_TRUE(settled.wait());
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  };
  flyThere(Focus{.box = {Eigen::Vector3d(0, -0.1, 0), Eigen::Vector3d(0.4, 0.1, 0.4)}});
  EXPECT_EQ(bar(), before) << "the plant fills the view, and from place to place all would move";
  view_.focusOff();
  camera.focus = {0.21, 0, 0.21};
  flyThere(std::nullopt);
  EXPECT_FALSE(plantBox().intersects(bar())) << bar().x();
}

TEST_F(GivesWay, TheHandlesAreWhereTheColorsArePainted) {
  showWithItsEdgeAt({0.2, 0, 0.2}); // which covers the upper right
  const QRectF bar = this->bar();
  const QImage seen = view_.grab().toImage();
  const QColor color = seen.pixelColor(QPoint(int(bar.right()) - 15, int(bar.center().y())));
  EXPECT_GT(color.hsvSaturation(), 100) << "of the middle of the bar";
}

TEST_F(GivesWay, NothingMovesWhileTheCameraDoes) {
  showWithItsEdgeAt({0.2, 0, 0.2});
  const QRectF before = bar();
  Camera camera = view_.camera();
  camera.focus = {0.8, 0, 0.8};
  view_.setCamera(camera);
  QApplication::processEvents();
  EXPECT_EQ(bar(), before);
  EXPECT_TRUE(QTest::qWaitFor([&] { return bar() != before; }));
}

TEST_F(GivesWay, APictureIsAsTheView) {
  showWithItsEdgeAt({0.2, 0, 0.2});
  const QRectF bar = this->bar();
  const QImage picture = view_.picture({800, 600});
  const QColor color = picture.pixelColor(QPoint(int(bar.right()) - 15, int(bar.center().y())));
  EXPECT_GT(color.hsvSaturation(), 100) << "of the middle of the bar";
}

} // namespace
} // namespace espalier
