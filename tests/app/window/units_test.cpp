#include "core/mtg/mtg_reader.h"
#include "tests/app/window/window_fixture.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <fstream>
#include <map>

namespace espalier {
namespace {

struct UnitsWindowTest : test::WindowTest {
  NodeId nodeAt(const Eigen::Vector3d& place) {
    for (const NodeId id : document().skeleton().ids())
      if ((document().skeleton()[id].position - place).norm() < 1e-3) return id;
    ADD_FAILURE() << "no node there";
    return NodeId{0};
  }
  /// Presses Commit with this class.
  static std::function<void(QDialog&)> commitAs(const QString& symbol) {
    return [symbol](QDialog& dialog) {
      dialog.findChild<QLineEdit*>("unit_class")->setText(symbol);
      for (auto* button : dialog.findChildren<QPushButton*>())
        if (button->text().remove('&') == "Commit") button->click();
    };
  }
  [[nodiscard]] std::map<int, int> verticesPerScale(const QString& name) const {
    std::ifstream in(path(name).toStdString());
    std::map<int, int> counts;
    for (const MtgVertex& vertex : readMtg(in, name.toStdString()).value.vertices)
      ++counts[vertex.scale];
    return counts;
  }
};

TEST_F(UnitsWindowTest, MarksBecomeAScaleOfTheSavedFile) {
  open({writeFork("fork.mtg")}); // five nodes: a root, its top, three shoots
  EXPECT_FALSE(action("commit_marks").isEnabled());
  hover(placeOf(nodeAt({1, 0, 2})));
  key(Qt::Key_U);
  EXPECT_TRUE(document().skeleton()[nodeAt({1, 0, 2})].isMarked);
  EXPECT_TRUE(window().statusLine().counts().contains("1 marked"));
  ASSERT_TRUE(action("commit_marks").isEnabled());
  QString outcome;
  answer(
      [&](QDialog& dialog) {
        outcome = dialog.findChild<QLabel*>("unit_outcome")->text();
        commitAs("S")(dialog);
      },
      [this] { action("commit_marks").trigger(); });
  EXPECT_TRUE(outcome.startsWith("Makes 2 units of scale 2 from 1 mark:")) << outcome.toStdString();
  EXPECT_EQ(document().undoStack().undoText(), "Commit the marks to S");
  EXPECT_FALSE(action("commit_marks").isEnabled());
  action("save").trigger();
  EXPECT_EQ(verticesPerScale("fork.mtg"), (std::map<int, int>{{1, 1}, {2, 2}, {3, 5}}));
  action("undo").trigger();
  EXPECT_TRUE(action("commit_marks").isEnabled()) << "the marks are back";
  action("save").trigger();
  EXPECT_EQ(verticesPerScale("fork.mtg"), (std::map<int, int>{{1, 1}, {2, 5}}));
}

TEST_F(UnitsWindowTest, AClassThatIsTakenIsRefusedAndCanBeCorrected) {
  open({writeFork("fork.mtg")});
  document().selection().set({nodeAt({1, 0, 2})});
  action("mark_unit_start").trigger();
  const int steps = document().undoStack().count();
  answer(
      [&](QDialog& dialog) {
        commitAs("N")(dialog);
        EXPECT_TRUE(dialog.isVisible());
        EXPECT_EQ(document().undoStack().count(), steps);
        commitAs("S")(dialog);
        EXPECT_FALSE(dialog.isVisible());
      },
      [this] { action("commit_marks").trigger(); });
  EXPECT_EQ(document().undoStack().count(), steps + 1);
}

TEST_F(UnitsWindowTest, MarksAreClearedInOneStep) {
  open({writeFork("fork.mtg")});
  action("select_all").trigger();
  action("mark_unit_start").trigger();
  action("clear_marks").trigger();
  EXPECT_EQ(document().undoStack().count(), 2);
  EXPECT_FALSE(window().statusLine().counts().contains("marked"));
}

TEST_F(UnitsWindowTest, TheInspectorTakesAnIndexAndRefusesAWrongOne) {
  open({writeFork("fork.mtg")});
  document().selection().set({nodeAt({1, 0, 2})});
  auto& index = find<QLineEdit>("index_2");
  index.setFocus();
  QTest::keyClicks(&index, "x");
  QTest::keyClick(&index, Qt::Key_Return);
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_EQ(
      window().statusLine().shownText(),
      "'x' is no index: type a whole number, such as 3, two parted by a dot, such as 16.1, or "
      "nothing");
  index.selectAll();
  QTest::keyClicks(&index, "7");
  QTest::keyClick(&index, Qt::Key_Return);
  EXPECT_EQ(document().skeleton()[nodeAt({1, 0, 2})].entities.back().index, 7);
  EXPECT_TRUE(view().hasFocus());
}

/// Types into the fields of the dialog and presses Add.
void addValue(QDialog& dialog, const QString& name, const QString& type, const QString& value) {
  if (!name.isEmpty()) {
    auto* field = dialog.findChild<QLineEdit*>("feature_name");
    field->selectAll();
    QTest::keyClicks(field, name);
  }
  auto* types = dialog.findChild<QComboBox*>("feature_type");
  if (!type.isEmpty()) types->setCurrentIndex(types->findData(type));
  auto* field = dialog.findChild<QLineEdit*>("feature_value");
  field->selectAll();
  QTest::keyClicks(field, value);
  QTest::keyClick(field, Qt::Key_Return);
}

TEST_F(UnitsWindowTest, AFeatureIsAddedInTheInspectorAndDeclaredInTheSavedFile) {
  open({writeFork("fork.mtg")});
  document().selection().set({nodeAt({1, 0, 2})});
  answer(
      [&](QDialog& dialog) {
        addValue(dialog, "leaf area", "REAL", "2.5");
        EXPECT_TRUE(window().statusLine().shownText().contains("no name of a feature"));
        addValue(dialog, "Leaf_area", "REAL", "big");
        EXPECT_EQ(window().statusLine().shownText(),
                  "Leaf_area is of type REAL: 'big' is not a number, such as 12.5");
        EXPECT_TRUE(dialog.isVisible());
        EXPECT_EQ(document().undoStack().count(), 0);
        addValue(dialog, "", "", "2.5");
        EXPECT_FALSE(dialog.isVisible());
      },
      [this] { clickButton("add_feature_unit_2"); });
  EXPECT_TRUE(document().undoStack().undoText().startsWith("Add the feature Leaf_area to node"));
  EXPECT_EQ(find<QLineEdit>("feature_Leaf_area_2").text(), "2.5");
  action("save").trigger();
  std::ifstream in(path("fork.mtg").toStdString());
  EXPECT_EQ(readMtg(in, "fork.mtg").value.features.back(), (MtgFeature{"Leaf_area", "REAL"}));
  action("undo").trigger();
  EXPECT_EQ(window().findChild<QLineEdit*>("feature_Leaf_area_2"), nullptr);
}

TEST_F(UnitsWindowTest, APlantWithoutUnitsTakesAFeature) {
  open({writeScan("plant.xyz")});
  action("reconstruct").trigger();
  waitForJob();
  const NodeId root = document().skeleton().roots().front();
  document().selection().set({root});
  EXPECT_EQ(find<QLabel>("title_unit_2").text(), "No features yet");
  answer([](QDialog& dialog) { addValue(dialog, "Species", "ALPHA", "cherry"); },
         [this] { clickButton("add_feature_unit_2"); });
  EXPECT_EQ(find<QLineEdit>("feature_Species_2").text(), "cherry");
  EXPECT_EQ(document().skeleton()[root].entities.back().symbol, "N");
  action("undo").trigger();
  EXPECT_EQ(find<QLabel>("title_unit_2").text(), "No features yet");
}

TEST_F(UnitsWindowTest, ALaterDateIsAddedInTheInspector) {
  open({writeFork("fork.mtg")});
  const NodeId id = nodeAt({1, 0, 2});
  document().selection().set({id});
  answer([](QDialog& dialog) { addValue(dialog, "Day", "DD/MM/YY", "01/05/98"); },
         [this] { clickButton("add_feature_unit_2"); });
  answer(
      [&](QDialog& dialog) {
        addValue(dialog, "", "", "31/04/98");
        EXPECT_TRUE(dialog.isVisible()) << "April has 30 days";
        addValue(dialog, "", "", "30/04/99");
      },
      [this] { clickButton("add_date_unit_2"); });
  EXPECT_EQ(document().skeleton()[id].entities.back().later,
            (std::vector<std::vector<FeatureValue>>{{{"Day", "30/04/99", "DD/MM/YY"}}}));
  EXPECT_EQ(find<QLineEdit>("feature_Day_2_later0").text(), "30/04/99");
}

} // namespace
} // namespace espalier
