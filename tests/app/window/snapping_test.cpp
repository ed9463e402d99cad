// A node is slid along its axis, and snapped, by mouse and keys in the real window.
#include "app/window/files/load_files.h"
#include "core/io/formats.h"
#include "tests/app/window/window_fixture.h"

#include <QAction>
#include <QMouseEvent>
#include <QTest>

namespace espalier {
namespace {

/// Over the scan of a trunk of radius 0.05 about the z axis, with a node each 0.25 m of it and
/// contracted points on the axis, seen from the front.
class SnappingTest : public test::WindowTest {
protected:
  void SetUp() override {
    Skeleton trunk;
    std::optional<NodeId> last;
    for (int i = 0; i <= 8; ++i)
      last = trunk.add({.position = {0, 0, 0.25 * i}, .radius = 0.05, .parent = last});
    writeStructure(toPath(path("trunk.mtg")), trunk);
    open({writeScan("scan.xyz"), path("trunk.mtg")});
    const PointCloud& cloud = *document().scan()->cloud();
    Eigen::Matrix3Xf contracted = cloud.positions();
    for (int axis : {0, 1})
      contracted.row(axis).setConstant(static_cast<float>(-cloud.origin()[axis]));
    document().setContracted(std::make_shared<const Eigen::Matrix3Xf>(std::move(contracted)));
    action("view_front").trigger();
    waitForView();
    node_ = nodeAt({0, 0, 0.5}); // below all branches
    start_ = document().skeleton()[node_].position;
  }

  [[nodiscard]] Eigen::Vector3d place() { return document().skeleton()[node_].position; }
  /// From the node, by this shift in the plane of the screen [L].
  void dragBy(const Eigen::Vector3d& shift, Qt::KeyboardModifiers modifiers) {
    const QPoint from = placeOf(node_);
    const QPoint to = view().project(start_ + shift)->toPoint();
    hover(from);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::NoModifier);
    send(QEvent::MouseMove, (from + to) / 2, Qt::NoButton, modifiers);
    send(QEvent::MouseMove, to, Qt::NoButton, modifiers);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, modifiers);
  }
  void expectUndone() {
    action("undo").trigger();
    EXPECT_EQ(place(), start_);
  }

  NodeId node_{};
  Eigen::Vector3d start_;

private:
  void send(QEvent::Type type, const QPoint& at, Qt::MouseButton button,
            Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(type, QPointF(at), QPointF(view().mapToGlobal(at)), button, Qt::LeftButton,
                      modifiers);
    QCoreApplication::sendEvent(&view(), &event);
  }
};

TEST_F(SnappingTest, ShiftSlidesANodeAlongItsAxis) {
  dragBy({0.3, 0, 0.02}, Qt::ShiftModifier);
  EXPECT_LT((place() - start_).head<2>().norm(), 1e-6) << "the trunk is upright";
  EXPECT_GT(place().z(), start_.z());
  expectUndone();
  dragBy({0.3, 0, 0.02}, Qt::NoModifier);
  EXPECT_GT(place().x() - start_.x(), 0.25) << "without Shift it follows the pointer";
  expectUndone();
}

TEST_F(SnappingTest, CtrlKeepsANodeInTheMiddleOfTheWood) {
  dragBy({0.04, 0, 0}, Qt::NoModifier);
  EXPECT_GT(place().x() - start_.x(), 0.03);
  expectUndone();
  dragBy({0.04, 0, 0}, Qt::ControlModifier);
  EXPECT_LT(place().head<2>().norm(), 0.01);
  expectUndone();
}

TEST_F(SnappingTest, AMenuChoosesWhatNodesSnapTo) {
  EXPECT_TRUE(action("snap_off").isChecked());
  action("snap_section").trigger();
  dragBy({0.04, 0, 0}, Qt::NoModifier);
  EXPECT_LT(place().head<2>().norm(), 0.01);
  expectUndone();
  action("snap_contracted").trigger();
  EXPECT_TRUE(action("snap_contracted").isChecked());
  EXPECT_FALSE(action("snap_section").isChecked());
  dragBy({0.04, 0, 0}, Qt::NoModifier);
  EXPECT_LT(place().head<2>().norm(), 1e-5) << "they are on the axis";
  expectUndone();
  dragBy({0.04, 0, 0}, Qt::ControlModifier);
  EXPECT_GT(place().x() - start_.x(), 0.03) << "Ctrl lets it go";
  expectUndone();
}

TEST_F(SnappingTest, WhatNodesSnapToIsRemembered) {
  action("snap_section").trigger();
  restart();
  EXPECT_TRUE(action("snap_section").isChecked()) << "before there is a scan, too";
  SetUp();
  dragBy({0.04, 0, 0}, Qt::NoModifier);
  EXPECT_LT(place().head<2>().norm(), 0.01);
  action("snap_off").trigger();
  restart();
  EXPECT_TRUE(action("snap_off").isChecked());
}

TEST_F(SnappingTest, NothingSnapsToWhatIsNotThere) {
  document().setContracted(nullptr);
  action("snap_contracted").trigger();
  EXPECT_TRUE(action("snap_off").isChecked()) << "refused";
}

} // namespace
} // namespace espalier
