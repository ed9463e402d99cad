#include "tests/app/window/project_fixture.h"
#include "ui/panels/history_model.h"
#include "ui/panels/status_line.h"

#include <QDockWidget>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QUndoStack>

namespace espalier {
namespace {

struct HistoryWindowTest : test::ProjectWindowTest {
  void openForkAndEdit(int steps) {
    open({writeFork("fork.mtg")});
    for (int i = 1; i <= steps; ++i)
      setRadius(0.1 + 0.01 * i);
  }
  QTableView& list() { return find<QTableView>("history_list"); }
  QString text(int row) {
    return list().model()->index(row, HistoryModel::textColumn).data().toString();
  }
  void clickRow(int row) {
    const QModelIndex index = list().model()->index(row, HistoryModel::textColumn);
    list().scrollTo(index);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(index).center());
  }
  double radius() { return document().skeleton()[test::forkTop].radius; }
};

TEST_F(HistoryWindowTest, IsShownAndHiddenByItsKey) {
  openForkAndEdit(1);
  EXPECT_FALSE(find<QDockWidget>("history").isVisible());
  key(Qt::Key_F10);
  EXPECT_TRUE(find<QDockWidget>("history").isVisible());
  EXPECT_EQ(text(0), "Opened fork.mtg");
  EXPECT_EQ(text(1), "Radius");
  restart();
  EXPECT_FALSE(find<QDockWidget>("history").isVisible()) << "there is no plant";
  open({path("fork.mtg")});
  EXPECT_TRUE(find<QDockWidget>("history").isVisible()) << "as it was left";
  find<QDockWidget>("history").close();
  EXPECT_FALSE(action("show_history").isChecked());
}

TEST_F(HistoryWindowTest, ComesToTheFrontByItsKeyAndThenGoes) {
  openForkAndEdit(1);
  const auto isInFront = [&](const char* panel) {
    QCoreApplication::processEvents();
    return !find<QDockWidget>(panel).visibleRegion().isEmpty();
  };
  key(Qt::Key_F10);
  key(Qt::Key_F11);
  EXPECT_FALSE(isInFront("history")) << "it is behind the table of nodes";
  key(Qt::Key_F10);
  EXPECT_TRUE(isInFront("history"));
  EXPECT_FALSE(isInFront("node_table"));
  EXPECT_TRUE(action("show_history").isChecked());
  key(Qt::Key_F10);
  EXPECT_TRUE(find<QDockWidget>("history").isHidden());
  EXPECT_FALSE(action("show_history").isChecked());
  EXPECT_TRUE(isInFront("node_table"));
}

TEST_F(HistoryWindowTest, AClickGoesBackAndForth) {
  openForkAndEdit(5);
  key(Qt::Key_F10);
  clickRow(2);
  EXPECT_NEAR(radius(), 0.12, 1e-12);
  EXPECT_EQ(document().undoStack().index(), 2);
  EXPECT_EQ(document().undoStack().count(), 5);
  EXPECT_EQ(window().statusLine().shownText(), "Undone: 3 steps");
  clickRow(5);
  EXPECT_NEAR(radius(), 0.15, 1e-12);
  EXPECT_EQ(window().statusLine().shownText(), "Redone: 3 steps");
  clickRow(4);
  EXPECT_EQ(window().statusLine().shownText(), "Undone: Radius");
}

TEST_F(HistoryWindowTest, FollowsUndoByItsKey) {
  openForkAndEdit(3);
  key(Qt::Key_F10);
  EXPECT_EQ(list().currentIndex().row(), 3);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(list().currentIndex().row(), 2);
}

TEST_F(HistoryWindowTest, EnterGoesToTheRowAndMarksNothing) {
  openForkAndEdit(3);
  key(Qt::Key_F10);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Up);
  EXPECT_EQ(document().undoStack().index(), 3) << "to walk in the list undoes nothing";
  QTest::keyClick(&list(), Qt::Key_Return);
  EXPECT_EQ(document().undoStack().index(), 2);
}

TEST_F(HistoryWindowTest, AThousandStepsAreOneChangeToTheWindow) {
  openForkAndEdit(1000);
  key(Qt::Key_F10);
  const QSignalSpy edits(&document(), &PlantDocument::skeletonEdited);
  clickRow(0);
  EXPECT_EQ(document().undoStack().index(), 0);
  EXPECT_EQ(edits.size(), 1);
}

TEST_F(HistoryWindowTest, AProjectComesBackWithItsStepsAndAGap) {
  openForkAndEdit(2);
  const QString file = saveProject("plant.espalier");
  window().close();
  restart();
  open({file});
  key(Qt::Key_F10);
  EXPECT_EQ(text(3), "Opened here");
  clickRow(3);
  EXPECT_EQ(document().undoStack().index(), 2) << "a gap is no step";
  clickRow(0);
  EXPECT_EQ(document().undoStack().index(), 0);
  EXPECT_NEAR(radius(), 0.1, 1e-12);
}

TEST_F(HistoryWindowTest, AReadOnlyPlantStaysAsItIs) {
  openForkAndEdit(2);
  key(Qt::Key_F10);
  document().setReadOnly("save it elsewhere to edit it");
  clickRow(0);
  EXPECT_EQ(document().undoStack().index(), 2);
  EXPECT_TRUE(message().contains("Save it elsewhere"));
}

} // namespace
} // namespace espalier
