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
  broken.row.problem = ShownMessage{"is damaged: take a copy", {}, FilePlace{"/plants/f.espalier"}};
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

TEST(WorklistModel, SaysWhatIsWrongWithALineThatNamesNoFile) {
  WorklistModel model;
  ListedPlant missing;
  missing.row.named = "wood/oak.las";
  missing.row.problem =
      ShownMessage{"there is no file %1: correct it", {"'wood/oak.las'"}, FilePlace{"list.csv", 3}};
  model.show({missing}, {});
  EXPECT_EQ(cell(model, WorklistModel::plantColumn), "wood/oak.las");
  EXPECT_EQ(cell(model, WorklistModel::stateColumn), "There is no file 'wood/oak.las': correct it");
  EXPECT_TRUE(model.index(0, 0).data(Qt::ToolTipRole).toString().contains("list.csv, line 3"));
}

TEST(WorklistModel, CountsWholeMinutesAsASealAndShowsWhatIsNotKnownAsADash) {
  WorklistModel model;
  const auto minutes = [&](std::int64_t milliseconds) {
    model.show({plantOf("a.espalier", WorkStage::inReview, milliseconds)}, {});
    return cell(model, WorklistModel::minutesColumn);
  };
  EXPECT_EQ(minutes(0), "–");
  EXPECT_EQ(minutes(29'000), "under 1");
  EXPECT_EQ(minutes(59'000), "under 1");
  EXPECT_EQ(minutes(61'000), "1");
  EXPECT_EQ(minutes(779'000), "12");
  EXPECT_EQ(cell(model, WorklistModel::findingsColumn), "–");
  EXPECT_EQ(cell(model, WorklistModel::agreementColumn), "–");
}

TEST(WorklistModel, SaysWithinWhichDistanceTwoAgree) {
  WorklistModel model;
  ListedPlant plant = plantOf("a.espalier", WorkStage::inReview);
  plant.agreement = {.with = "Ben", .distance = 0.012, .f = 0.93, .structural = 0.88};
  model.show({plant}, {});
  EXPECT_EQ(cell(model, WorklistModel::agreementColumn), "0.93");
  const std::string tip = model.index(0, 0).data(Qt::ToolTipRole).toString().toStdString();
  EXPECT_NE(tip.find("F 0.93 within 0.0120, T 0.88 with Ben"), std::string::npos) << tip;
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

TEST(WorklistModel, ShowsTheFoldersOfPlantsWithOneName) {
  WorklistModel model;
  std::vector<ListedPlant> plants;
  for (const char* file : {"north/1/plot.ply", "north/2/plot.ply", "south/1/plot.ply", "oak.ply"})
    plants.push_back(plantOf(file, WorkStage::toDo));
  model.show(plants, {});
  QStringList names;
  for (int row = 0; row < model.rowCount(); ++row)
    names.append(cell(model, WorklistModel::plantColumn, row));
  EXPECT_EQ(names, QStringList({"plot.ply · north/1", "plot.ply · north/2", "plot.ply · south/1",
                                "oak.ply"}));
  plants.erase(plants.begin());
  model.show(plants, {});
  EXPECT_EQ(cell(model, WorklistModel::plantColumn), "plot.ply · 2") << "as far as is needed";
}

TEST(WorklistModel, ShowsEachCellOnOneLineAndNotTooLong) {
  WorklistModel model;
  ListedPlant plant = plantOf("two\nlines.ply", WorkStage::finished);
  const std::string endless(100'000, 'x');
  plant.row.annotator = plant.row.second = plant.row.state->seal->author = endless;
  plant.row.others = {endless};
  model.show({plant}, {QString::fromStdString(endless)});
  EXPECT_EQ(cell(model, WorklistModel::plantColumn), "two?lines.ply");
  for (int column = 0; column < model.columnCount(); ++column) {
    EXPECT_LT(cell(model, column).size(), 300) << column;
    EXPECT_LT(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().size(), 300);
  }
  plant.row.problem = ShownMessage{endless};
  model.show({plant}, {});
  EXPECT_LT(cell(model, WorklistModel::stateColumn).size(), 300);
}

TEST(WorklistModel, LeavesTheNameOfATableAsItIs) {
  const WorklistRow row{.problem =
                            ShownMessage{"no file is named", {}, FilePlace{"my list.csv", 3}}};
  EXPECT_EQ(stateText(row), "my list.csv, line 3: no file is named");
}

} // namespace
} // namespace espalier
