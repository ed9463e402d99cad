#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QTest>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;

struct MeasureWindowTest : test::WindowTest {
  void measureTrunk() {
    open({writeFork("fork.mtg")});
    key(Qt::Key_I);
    click(placeOf(forkRoot));
    click(placeOf(forkTop));
  }
  QString statusText() { return window().statusLine().shownText(); }
};

TEST_F(MeasureWindowTest, TwoClicksShowTheLengthInTheStatusLine) {
  measureTrunk();
  EXPECT_TRUE(statusText().startsWith("straight 1.000\u202fm   along the plant 1.000\u202fm"))
      << statusText().toStdString();
  EXPECT_TRUE(document().selection().isEmpty()) << "to measure selects nothing";
}

TEST_F(MeasureWindowTest, EnterTakesTheNodeThatIsSelected) {
  open({writeFork("fork.mtg")});
  key(Qt::Key_F9); // where Enter would mark it as reviewed
  key(Qt::Key_I);
  document().selection().set({forkRoot});
  EXPECT_TRUE(statusText().contains("Enter takes node")) << statusText().toStdString();
  key(Qt::Key_Return);
  key(Qt::Key_Return);
  EXPECT_TRUE(statusText().startsWith("Click the other end")) << "the same node again is none";
  document().selection().set({forkTop});
  key(Qt::Key_Return);
  EXPECT_TRUE(statusText().startsWith("straight 1.000\u202fm   along the plant 1.000\u202fm"))
      << statusText().toStdString();
  key(Qt::Key_Return); // one too many
  EXPECT_EQ(document().undoStack().index(), 0);
  EXPECT_EQ(document().skeleton()[forkTop].review.state, ReviewState::toDo);
  EXPECT_TRUE(action("mark_doubtful").isEnabled()) << "other marks stay at hand";
}

TEST_F(MeasureWindowTest, CtrlCCopiesIt) {
  measureTrunk();
  document().selection().set({forkTop});
  key(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(),
            "straight 1.000\u202fm   along the plant 1.000\u202fm");
}

TEST_F(MeasureWindowTest, EscapeClearsItAndThenLeavesTheTool) {
  measureTrunk();
  key(Qt::Key_Escape);
  EXPECT_TRUE(statusText().startsWith("Click two nodes")) << statusText().toStdString();
  EXPECT_TRUE(action("tool_measure").isChecked());
  key(Qt::Key_Escape);
  EXPECT_TRUE(action("tool_move").isChecked());
}

TEST_F(MeasureWindowTest, AnotherToolClearsItAndUndoStillUndoes) {
  measureTrunk();
  edit();
  EXPECT_TRUE(statusText().contains("straight") || statusText() == "Move")
      << statusText().toStdString();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().index(), 0);
  key(Qt::Key_S);
  key(Qt::Key_I);
  EXPECT_FALSE(statusText().contains("straight")) << statusText().toStdString();
}

} // namespace
} // namespace espalier
