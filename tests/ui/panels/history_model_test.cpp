#include "tests/support/plants.h"
#include "ui/document/plant_document.h"
#include "ui/panels/history_model.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace espalier {
namespace {

struct HistoryModelTest : testing::Test {
  PlantDocument document;
  HistoryModel model{document};

  void SetUp() override { document.openSkeleton(test::stick(3), "/plants/stick.mtg"); }
  void setRadius(double radius) {
    document.setAuthor("Ada");
    document.edit("Radius " + QString::number(radius),
                  [=](SkeletonEditor& editor) { editor.setRadius(NodeId{1}, radius); });
  }
  QString text(int row, int column = HistoryModel::textColumn) {
    return model.data(model.index(row, column), Qt::DisplayRole).toString();
  }
};

TEST_F(HistoryModelTest, BeginsWithHowThePlantWasOpened) {
  EXPECT_EQ(model.rowCount(), 1);
  EXPECT_EQ(text(0), "Opened stick.mtg");
  EXPECT_EQ(model.currentRow(), 0);
}

TEST_F(HistoryModelTest, HasARowPerStepWithItsTimeAndAuthor) {
  setRadius(1);
  setRadius(2);
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(text(2), "Radius 2");
  EXPECT_EQ(text(2, HistoryModel::authorColumn), "Ada");
  EXPECT_FALSE(text(2, HistoryModel::timeColumn).isEmpty());
  EXPECT_EQ(model.currentRow(), 2);
}

TEST_F(HistoryModelTest, MarksThePresentStepAndKeepsThoseUndone) {
  setRadius(1);
  setRadius(2);
  document.undoStack().undo();
  EXPECT_EQ(model.rowCount(), 3);
  EXPECT_EQ(text(1, HistoryModel::markColumn), "▸");
  EXPECT_EQ(text(2, HistoryModel::markColumn), "");
  EXPECT_TRUE(model.data(model.index(2, 1), Qt::ForegroundRole).isValid()) << "faint";
  EXPECT_FALSE(model.data(model.index(1, 1), Qt::ForegroundRole).isValid());
  setRadius(3);
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(text(2), "Radius 3");
}

TEST_F(HistoryModelTest, ShowsAGapWhereTheFileWasOpened) {
  setRadius(1);
  setRadius(2);
  document.openHistory(document.history(), nullptr, "/plants/plant.espalier");
  EXPECT_EQ(document.openedSteps(), 2);
  setRadius(3);
  ASSERT_EQ(model.rowCount(), 5);
  EXPECT_EQ(text(0), "The beginning");
  EXPECT_EQ(text(3), "Opened here");
  EXPECT_EQ(model.positionOf(3), -1);
  EXPECT_FALSE(model.flags(model.index(3, 1)).testFlag(Qt::ItemIsSelectable));
  EXPECT_EQ(text(4), "Radius 3");
  EXPECT_EQ(model.positionOf(4), 3);
  EXPECT_EQ(model.currentRow(), 4);
}

TEST_F(HistoryModelTest, MovesTheGapWhenAStepOfTheFileIsDropped) {
  setRadius(1);
  setRadius(2);
  document.openHistory(document.history(), nullptr, "/plants/plant.espalier");
  document.undoStack().undo();
  setRadius(3);
  EXPECT_EQ(document.openedSteps(), 1);
  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(text(2), "Opened here");
  EXPECT_EQ(text(3), "Radius 3");
}

TEST_F(HistoryModelTest, EndsWithAnotherPlant) {
  setRadius(1);
  document.openSkeleton(test::fork(2), "/plants/fork.mtg");
  EXPECT_EQ(model.rowCount(), 1);
  EXPECT_EQ(text(0), "Opened fork.mtg");
}

} // namespace
} // namespace espalier
