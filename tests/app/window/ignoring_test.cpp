// What is ignored, as steps of Undo and Redo.
#include "tests/app/window/findings_fixture.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QUndoStack>

namespace espalier {
namespace {

using test::FindingsWindowTest;

TEST_F(FindingsWindowTest, UndoAndRedoPassThroughWhatIsIgnoredInItsTurn) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  const int steps = document().undoStack().index();
  key(Qt::Key_F4);
  key(Qt::Key_F4, Qt::ControlModifier);
  ASSERT_EQ(countOf("Ignored"), "1");
  EXPECT_EQ(action("undo").text(), "&Undo: Ignore a finding");
  document().edit("Move", [&](SkeletonEditor& editor) {
    editor.setPosition(shoot(1), {0, 0.9, 2.6});
  });
  EXPECT_EQ(action("undo").text(), "&Undo: Move");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(countOf("Ignored"), "1");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().index(), steps) << "no step of the plant is undone";
  EXPECT_EQ(countOf("Ignored"), "");
  EXPECT_EQ(title(), "1 place may be wrong");
  EXPECT_EQ(window().statusLine().shownText(), "Undone: Ignore a finding");
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(countOf("Ignored"), "1");
  EXPECT_EQ(document().undoStack().index(), steps);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().undoStack().index(), steps + 1) << "then the step that was after it";
  chooseKind("Ignored");
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOfRow(0));
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_EQ(countOf("Ignored"), "");
  EXPECT_EQ(action("undo").text(), "&Undo: Show a finding again");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(countOf("Ignored"), "1");
}

TEST_F(FindingsWindowTest, ANewStepEndsWhatCouldBeIgnoredOnceMore) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  key(Qt::Key_F4);
  key(Qt::Key_F4, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(action("redo").text(), "&Redo: Ignore a finding");
  document().edit("Move", [&](SkeletonEditor& editor) {
    editor.setPosition(shoot(1), {0, 0.9, 2.6});
  });
  EXPECT_FALSE(action("redo").isEnabled());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(action("redo").text(), "&Redo: Move");
}

} // namespace
} // namespace espalier
