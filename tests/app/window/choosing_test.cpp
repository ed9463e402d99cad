#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QMouseEvent>
#include <QTest>

#include <gmock/gmock.h>

namespace espalier {
namespace {

/// Choosing by area in the real window.
class ChoosingTest : public test::WindowTest {
protected:
  void dragWith(Qt::KeyboardModifiers modifiers, const QPoint& from, const QPoint& to) {
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton button) {
      QMouseEvent event(type, QPointF(at), QPointF(view().mapToGlobal(at)), button, Qt::LeftButton,
                        modifiers);
      QCoreApplication::sendEvent(&view(), &event);
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton);
    send(QEvent::MouseMove, from + (to - from) / 2, Qt::NoButton);
    send(QEvent::MouseMove, to, Qt::NoButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton);
  }
  [[nodiscard]] QPoint pixel(NodeId id) {
    return view().project(document().skeleton()[id].position).value().toPoint();
  }
};

TEST_F(ChoosingTest, ChoosesTheNodesInABox) {
  open({writeFork("fork.mtg")});
  const NodeId root = nodeAt({0, 0, 0});
  const NodeId top = nodeAt({0, 0, 1});
  const QRect box = QRect(pixel(root), pixel(top)).normalized().adjusted(-20, -5, 20, 20);
  const Camera before = view().camera();
  dragWith(Qt::ShiftModifier, box.topLeft(), box.bottomRight());
  EXPECT_THAT(document().selection().nodes(), testing::UnorderedElementsAre(root, top));
  EXPECT_EQ(view().camera(), before);
}

// The scan is a trunk of radius 0.05; a node behind it is seen through it only when asked.
TEST_F(ChoosingTest, TakesWhatIsBehindWoodOnlyWhenAsked) {
  open({writeScan("scan.xyz")});
  NodeId behind{};
  document().edit("Add", [&](SkeletonEditor& editor) {
    behind = editor.add({.position = {0, 0.4, 0.4}, .radius = 0.001});
  });
  key(Qt::Key_5); // the front
  waitForView();
  const QPoint at = pixel(behind);
  const QPoint reach(8, 8);
  dragWith(Qt::ShiftModifier, at - reach, at + reach);
  EXPECT_TRUE(document().selection().isEmpty());
  dragWith(Qt::ShiftModifier | Qt::ControlModifier, at - reach, at + reach);
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(behind));
  document().selection().clear();
  action("select_through").trigger();
  click(at);
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(behind));
  action("select_through").trigger();
  click(at);
  EXPECT_TRUE(document().selection().isEmpty());
}

TEST_F(ChoosingTest, SevenChoosesWhatIsNotReviewed) {
  open({writeFork("fork.mtg")});
  const NodeId root = nodeAt({0, 0, 0});
  document().edit("Mark", [&](SkeletonEditor& editor) {
    for (const NodeId id : editor.skeleton().ids())
      editor.setReview(id, {id == root ? ReviewState::doubtful : ReviewState::reviewed});
  });
  key(Qt::Key_7);
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(root));
}

// Choosing is no edit: clicks, boxes and keys work, and nothing else does.
TEST_F(ChoosingTest, ChoosesInAPlantThatMayNotBeEdited) {
  open({writeFork("fork.mtg")});
  key(Qt::Key_L); // a tool that edits is left
  document().setReadOnly("it is signed");
  EXPECT_TRUE(action("tool_move").isChecked());
  EXPECT_FALSE(action("tool_trace").isEnabled());
  const Skeleton before = document().skeleton();
  const NodeId root = nodeAt({0, 0, 0});
  const NodeId top = nodeAt({0, 0, 1});
  click(placeOf(top));
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(top));
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Read-only"));
  key(Qt::Key_2);
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(top, root));
  const QRect box = QRect(pixel(root), pixel(top)).normalized().adjusted(-20, -5, 20, 20);
  document().selection().clear();
  dragWith(Qt::ShiftModifier, box.topLeft(), box.bottomRight());
  EXPECT_THAT(document().selection().nodes(), testing::UnorderedElementsAre(root, top));
  const Camera camera = view().camera();
  drag(placeOf(top), placeOf(top) + QPoint(60, 0)); // turns
  EXPECT_NE(view().camera(), camera);
  key(Qt::Key_Delete);
  EXPECT_EQ(document().skeleton(), before);
  EXPECT_EQ(document().undoStack().count(), 0);
}

} // namespace
} // namespace espalier
