#include "ui/panels/worklist_panel.h"

#include <QAction>
#include <QLabel>
#include <QTableView>
#include <gtest/gtest.h>

namespace espalier {
namespace {

struct WorklistPanelTest : testing::Test {
  QAction folder, table, next;
  WorklistPanel panel{{&folder, &table, &next}};

  static ListedPlant plant(const std::string& file, WorkStage stage, bool isRead = true) {
    ListedPlant made;
    made.row.project = "/plants/" + file;
    made.row.isRead = isRead;
    if (isRead) made.row.state = WorkState{.stage = stage};
    if (isRead && stage == WorkStage::finished) made.row.state->seal = Seal{.author = "Anna"};
    return made;
  }
  [[nodiscard]] std::string following(const std::string& file) const {
    std::string names;
    for (const WorklistRow& row : panel.following(QString::fromStdString("/plants/" + file)))
      names += row.file().stem().string();
    return names;
  }
  [[nodiscard]] QString title() const { return panel.findChild<QLabel*>("worklist_title")->text(); }
  [[nodiscard]] QString note() const { return panel.findChild<QLabel*>("worklist_note")->text(); }
};

// Whether it is signed is not known.
TEST_F(WorklistPanelTest, PassesOverPlantsThatAreStillRead) {
  panel.show("plants", {},
             {plant("a.espalier", WorkStage::inReview),
              plant("b.espalier", WorkStage::finished, false),
              plant("c.espalier", WorkStage::finished), plant("d.espalier", WorkStage::toDo)},
             {});
  EXPECT_EQ(following("a.espalier"), "d");
  EXPECT_EQ(following("d.espalier"), "a");
  EXPECT_EQ(following("none.espalier"), "ad");
  EXPECT_TRUE(panel.isReading());
  panel.show("plants", {}, {plant("a.espalier", WorkStage::inReview)}, {});
  EXPECT_FALSE(panel.isReading());
}

TEST_F(WorklistPanelTest, KeepsTheOrderOfATable) {
  const auto plants = [] {
    return std::vector{plant("b.espalier", WorkStage::toDo), plant("a.espalier", WorkStage::toDo),
                       plant("c.espalier", WorkStage::toDo)};
  };
  panel.show("list.csv", {}, plants(), {}, true);
  EXPECT_EQ(following("none.espalier"), "bac");
  panel.findChild<QTableView*>("worklist")->sortByColumn(0, Qt::DescendingOrder);
  panel.show("list.csv", {}, plants(), {}, true);
  EXPECT_EQ(following("none.espalier"), "cba") << "chosen by its head";
  panel.show("plants", {}, plants(), {});
  EXPECT_EQ(following("none.espalier"), "abc");
}

TEST_F(WorklistPanelTest, SaysThatTheListIsRead) {
  panel.show("huge.csv", {}, {}, {});
  EXPECT_EQ(title(), "huge.csv");
  EXPECT_EQ(note(), "The worklist is being read.");
  panel.show("huge.csv", {}, {plant("a.espalier", WorkStage::toDo)}, {});
  EXPECT_EQ(title(), "huge.csv · 1 plant: 1 to do");
  EXPECT_EQ(note(), "");
}

} // namespace
} // namespace espalier
