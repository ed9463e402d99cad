#include "ui/panels/worklist_model.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace espalier {
namespace {

ListedPlant plantOf(const std::string& file, WorkStage stage, std::int64_t time = 0) {
  ListedPlant plant;
  plant.row.project = "/plants/" + file;
  plant.row.state = WorkState{.stage = stage, .nodes = 7, .time = time};
  if (stage == WorkStage::finished) plant.row.state->seal = Seal{.author = "Anna"};
  return plant;
}

QString cell(const WorklistModel& model, int column, int row = 0) {
  return model.index(row, column).data().toString();
}

TEST(WorklistModel, SaysHowFarEachPlantIs) {
  WorklistModel model;
  ListedPlant unread = plantOf("e.espalier", WorkStage::toDo);
  unread.row.isRead = false;
  ListedPlant broken = plantOf("f.espalier", WorkStage::toDo);
  broken.row.problem = "/plants/f.espalier: is damaged: take a copy";
  model.show({plantOf("a.espalier", WorkStage::toDo), plantOf("b.espalier", WorkStage::automatic),
              plantOf("c.espalier", WorkStage::inReview),
              plantOf("d.espalier", WorkStage::finished), unread, broken},
             {});
  const QStringList texts = {"To do",          "Automatic", "In review",
                             "Signed by Anna", "Reading…",  "Is damaged: take a copy"};
  QString stages;
  for (int row = 0; row < model.rowCount(); ++row) {
    EXPECT_EQ(cell(model, WorklistModel::stateColumn, row), texts[row]);
    stages += model.index(row, 0).data(WorklistModel::stageRole).toString();
  }
  EXPECT_EQ(stages, "tarsup");
}

TEST(WorklistModel, RoundsMinutesAndShowsWhatIsNotKnownAsADash) {
  WorklistModel model;
  const auto minutes = [&](std::int64_t milliseconds) {
    model.show({plantOf("a.espalier", WorkStage::inReview, milliseconds)}, {});
    return cell(model, WorklistModel::minutesColumn);
  };
  EXPECT_EQ(minutes(0), "–");
  EXPECT_EQ(minutes(29'000), "under 1");
  EXPECT_EQ(minutes(31'000), "1");
  EXPECT_EQ(minutes(725'000), "12");
  EXPECT_EQ(cell(model, WorklistModel::findingsColumn), "–");
  EXPECT_EQ(cell(model, WorklistModel::agreementColumn), "–");
}

TEST(WorklistModel, KeepsItsRowsWhereOnlyTheirContentChanges) {
  WorklistModel model;
  model.show({plantOf("a.espalier", WorkStage::toDo)}, {});
  const QSignalSpy resets(&model, &WorklistModel::modelReset);
  const QSignalSpy changes(&model, &WorklistModel::dataChanged);
  model.show({plantOf("a.espalier", WorkStage::automatic)}, {});
  EXPECT_EQ(resets.count(), 0);
  EXPECT_EQ(changes.count(), 1);
  model.show({plantOf("b.espalier", WorkStage::automatic)}, {});
  EXPECT_EQ(resets.count(), 1);
}

TEST(WorklistModel, SortsFurtherColumnsAsNumbersWhereTheyAre) {
  WorklistModel model;
  ListedPlant plant = plantOf("a.espalier", WorkStage::toDo);
  plant.row.others = {"12", "tall"};
  model.show({plant}, {"plot", "note"});
  EXPECT_EQ(model.columnCount(), WorklistModel::columns + 2);
  const auto key = [&](int column) {
    return model.index(0, WorklistModel::columns + column).data(WorklistModel::sortRole);
  };
  EXPECT_EQ(key(0), QVariant(12.0));
  EXPECT_EQ(key(1), QVariant(QString("tall")));
}

} // namespace
} // namespace espalier
