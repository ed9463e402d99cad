// A plot is cut into its plants, and each is written as a project, in the real window.
#include "core/io/formats.h"
#include "core/simulate/plot.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/plot_panel.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QTest>

#include <algorithm>

namespace espalier {
namespace {

/// Over the scan of a plot of three plants, with ground, a pole and a wire.
class PlotTest : public test::ProjectWindowTest {
protected:
  void SetUp() override {
    PlotOptions options;
    options.growth.segments = 120;
    options.scanner.points = 30000;
    writePoints(toPath(path("plot.ply")), PointCloud(simulatePlot(options, 7).points));
    open({path("plot.ply")});
    action("show_plot").trigger();
  }

  [[nodiscard]] PointSet chosen() { return document().pointSelection().points(); }
  [[nodiscard]] QString words() { return find<QLabel>("plot_words").text(); }
  [[nodiscard]] QTableWidget& table() { return find<QTableWidget>("plot_plants"); }
  void findPlants() {
    clickButton("plot_find");
    waitUntilDone();
  }
  void waitUntilDone() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !find<QPushButton>("plot_cancel").isVisible(); },
                                patience));
  }
  void writeTo(const QString& folder) {
    answer(chooseFile(folder), [this] { clickButton("plot_write"); });
    waitUntilDone();
  }
  [[nodiscard]] QStringList filesIn(const QString& folder) {
    return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
  }
};

TEST_F(PlotTest, ListsThePlantsAndSelectsTheOneOfARow) {
  EXPECT_FALSE(table().isVisible()) << "nothing is found before one asks";
  findPlants();
  EXPECT_TRUE(words().startsWith("3 plants found. Of no plant: ")) << words().toStdString();
  ASSERT_EQ(table().rowCount(), 3);
  table().setCurrentCell(1, 1);
  const PointSet second = chosen();
  EXPECT_EQ(table().item(1, 1)->text(), formatCount(second.size()));
  table().setCurrentCell(2, 1);
  EXPECT_FALSE(chosen().isEmpty());
  EXPECT_TRUE((chosen() - second) == chosen()) << "no point is of two plants";
  EXPECT_EQ(document().undoStack().count(), 0) << "to find is no edit";
}

TEST_F(PlotTest, WritesAProjectOfEachPlantWithACheckMark) {
  findPlants();
  table().item(1, 0)->setCheckState(Qt::Unchecked);
  const QString folder = path("trees");
  QDir().mkdir(folder);
  writeTo(folder);
  EXPECT_EQ(filesIn(folder), QStringList({"plants.csv", "plot_1.espalier", "plot_1.ply",
                                          "plot_2.espalier", "plot_2.ply"}));
  EXPECT_EQ(message(), "Wrote 2 projects to " + folder);
  EXPECT_EQ(table().item(1, 0)->checkState(), Qt::Unchecked) << "as it was chosen";
  EXPECT_EQ(find<QPushButton>("banner_action").text(), "Show as Worklist");
  clickButton("banner_action");
  const auto& listed = *find<QTableView>("worklist").model();
  EXPECT_TRUE(QTest::qWaitFor([&] { return listed.rowCount() == 2; }, patience));
  const auto scan = Project::open(toPath(folder + "/plot_2.espalier"), Access::readOnly).findScan();
  ASSERT_TRUE(scan);
  table().setCurrentCell(2, 1);
  EXPECT_EQ(static_cast<std::size_t>(readPoints(*scan).value.size()), chosen().size());
  open({folder + "/plot_2.espalier"});
  EXPECT_EQ(static_cast<std::size_t>(document().scan()->cloud()->size()),
            static_cast<std::size_t>(readPoints(*scan).value.size()));
}

TEST_F(PlotTest, MakesAFolderOfANameThatIsTyped) {
  findPlants();
  const auto type = [](QDialog& dialog) {
    dialog.findChild<QLineEdit*>("fileNameEdit")->setText("new/trees");
    auto* choose = dialog.findChild<QDialogButtonBox*>("buttonBox")->button(QDialogButtonBox::Open);
    EXPECT_TRUE(choose->isEnabled());
    choose->click();
  };
  answer(type, [this] { clickButton("plot_write"); });
  waitUntilDone();
  EXPECT_TRUE(filesIn(path("new/trees")).contains("plants.csv")) << words().toStdString();
}

TEST_F(PlotTest, ReplacesNoFile) {
  findPlants();
  const QString folder = path("trees");
  QDir().mkdir(folder);
  QFile file(folder + "/plot_2.espalier");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("the work of days");
  file.close();
  writeTo(folder);
  EXPECT_TRUE(words().contains("plot_2.espalier: is there already")) << words().toStdString();
  EXPECT_EQ(filesIn(folder), QStringList({"plot_2.espalier"})) << "and nothing is half written";
  EXPECT_EQ(table().rowCount(), 3) << "they can be written to another folder";
}

TEST_F(PlotTest, CanBeCanceled) {
  find<QPushButton>("plot_find").setFocus();
  clickButton("plot_find");
  EXPECT_EQ(window().focusWidget(), &find<QWidget>("plot_cancel"));
  clickButton("plot_cancel");
  waitUntilDone();
  EXPECT_EQ(window().focusWidget(), &find<QWidget>("plot_find"));
  EXPECT_EQ(table().rowCount(), 0);
  EXPECT_TRUE(find<QPushButton>("plot_find").isEnabled());
}

TEST_F(PlotTest, KeepsThePlantsWhereFindingThemAgainIsCanceled) {
  findPlants();
  const QString before = words();
  clickButton("plot_find");
  clickButton("plot_cancel");
  waitUntilDone();
  EXPECT_EQ(table().rowCount(), 3);
  EXPECT_EQ(words(), before);
}

TEST_F(PlotTest, SaysWhyThereAreNone) {
  document().pointSelection().set(PointSet::firstOf(document().scan()->cloud()->size() - 1));
  action("set_points_aside").trigger();
  findPlants();
  EXPECT_EQ(table().rowCount(), 0);
  EXPECT_TRUE(words().contains("at the same place: check the scan")) << words().toStdString();
}

TEST_F(PlotTest, LeavesOutGroundPolesAndWiresUnlessThatIsOff) {
  find<QCheckBox>("plot_cleans").setChecked(false);
  findPlants();
  EXPECT_GT(table().rowCount(), 3) << "the pole stands like a stem";
}

TEST_F(PlotTest, LeavesOutNothingMoreOnceOneHasCleanedByHand) {
  auto& cleans = find<QCheckBox>("plot_cleans");
  EXPECT_TRUE(cleans.isChecked());
  document().pointSelection().set(PointSet::firstOf(5));
  action("set_points_aside").trigger();
  EXPECT_FALSE(cleans.isChecked()) << "without ground, a cloth touches branches";
  action("undo").trigger();
  EXPECT_TRUE(cleans.isChecked());
  findPlants();
  cleans.setChecked(false);
  EXPECT_EQ(table().rowCount(), 0) << "those were found otherwise";
}

TEST_F(PlotTest, ForgetsThePlantsOnceOtherPointsAreSetAside) {
  findPlants();
  table().setCurrentCell(0, 1);
  action("set_points_aside").trigger();
  EXPECT_EQ(table().rowCount(), 0);
  find<QCheckBox>("plot_cleans").setChecked(true);
  findPlants();
  EXPECT_EQ(table().rowCount(), 2) << "those set aside are of no plant";
  action("undo").trigger();
  EXPECT_EQ(table().rowCount(), 0);
}

TEST_F(PlotTest, IsNotCutOffInASmallWindow) {
  window().resize(1280, 800);
  findPlants();
  auto& panel = find<PlotPanel>("plot_panel");
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return table().columnViewportPosition(2) + table().columnWidth(2) <=
                   table().viewport()->width() &&
               panel.width() <= panel.parentWidget()->width();
      },
      patience));
}

} // namespace
} // namespace espalier
