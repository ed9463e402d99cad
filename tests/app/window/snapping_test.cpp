// A node is slid along its axis, and snapped, by mouse and keys in the real window.
#include "tests/app/window/window_fixture.h"

#include <QAction>
#include <QMouseEvent>
#include <QTest>

namespace espalier {
namespace {

/// Over the reconstruction of a trunk of radius 0.05 about the z axis, seen from the front.
class SnappingTest : public test::WindowTest {
protected:
  void SetUp() override {
    open({writeScan("scan.xyz")});
    action("reconstruct").trigger();
    waitForJob();
    action("view_front").trigger();
    waitForView();
    node_ = lowNode();
    start_ = document().skeleton()[node_].position;
  }

  /// A node of the trunk, below all branches, that is no root.
  NodeId lowNode() {
    for (const NodeId id : document().skeleton().ids()) {
      const Node& node = document().skeleton()[id];
      if (node.parent && node.position.z() > 0.3 && node.position.z() < 0.6) return id;
    }
    ADD_FAILURE() << "no node there";
    return document().skeleton().roots().front();
  }
  [[nodiscard]] Eigen::Vector3d place() { return document().skeleton()[node_].position; }
  /// From the node by this way in the plane of the screen [L].
  void dragBy(const Eigen::Vector3d& way, Qt::KeyboardModifiers modifiers) {
    const QPoint from = placeOf(node_);
    const QPoint to = view().project(start_ + way)->toPoint();
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
  EXPECT_LT((place() - start_).head<2>().norm(), 0.02) << "the trunk is upright";
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
  EXPECT_LT(place().head<2>().norm(), 0.02) << "they are in the middle of the wood";
  expectUndone();
  dragBy({0.04, 0, 0}, Qt::ControlModifier);
  EXPECT_GT(place().x() - start_.x(), 0.03) << "Ctrl lets it go";
  expectUndone();
}

TEST_F(SnappingTest, NothingSnapsToWhatIsNotThere) {
  document().setContracted(nullptr);
  action("snap_contracted").trigger();
  EXPECT_TRUE(action("snap_off").isChecked()) << "refused";
}

} // namespace
} // namespace espalier
