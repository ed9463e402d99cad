#include "app/window/evaluate/evaluation_flow.h"
#include "app/window/evaluate/reference_flow.h"
#include "core/project/project_lock.h"
#include "core/worklist/worklist.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/status_line.h"
#include "ui/panels/worklist_panel.h"

#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QIcon>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTableView>
#include <QTest>

#include <filesystem>
#include <fstream>
#include <memory>

namespace espalier {
namespace {

struct WorklistWindowTest : test::ProjectWindowTest {

  WorklistWindowTest() { QDir().mkpath(path("plants")); }

  /// A project of a fork, where `author` moved a node; of a scan, if one is named.
  QString writeProject(const QString& name, const QString& author, const QString& scan = {}) const {
    History history{.skeleton = test::fork(3)};
    SkeletonEditor editor(history.skeleton);
    editor.setRadius(NodeId{1}, 0.37);
    history.steps.push_back({.id = StepId{1},
                             .text = "Radius",
                             .author = author.toStdString(),
                             .time = 1,
                             .delta = editor.commit()});
    history.position = 1;
    Project project = Project::create(toPath(path("plants/" + name)), history);
    if (!scan.isEmpty()) project.setScan(ScanReference::of(toPath(scan), {}));
    return path("plants/" + name);
  }
  void chooseFolderOfPlants() {
    answer(chooseFile(path("plants")), [this] { action("worklist_folder").trigger(); });
  }
  QTableView& list() { return find<QTableView>("worklist"); }
  QString cell(int row, int column) { return list().model()->index(row, column).data().toString(); }
  /// As shown: "a.espalier: In review", of all rows.
  QStringList rows() {
    QStringList all;
    for (int row = 0; row < list().model()->rowCount(); ++row)
      all.append(cell(row, WorklistModel::plantColumn) + ": " +
                 cell(row, WorklistModel::stateColumn));
    return all;
  }
  [[nodiscard]] bool waitForRows(const QStringList& wanted) {
    return QTest::qWaitFor([&] { return rows() == wanted; }, patience);
  }
  /// There is an icon in any case: an empty one at first.
  bool hasPicture(int row) {
    const auto icon = list().model()->index(row, 0).data(Qt::DecorationRole).value<QIcon>();
    const QImage image = icon.pixmap(96, 96).toImage();
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, y).alpha() > 0) return true;
    return false;
  }
  void choose(int row) {
    list().setCurrentIndex(list().model()->index(row, 0));
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_Return);
    waitForJob();
  }
  void next() {
    action("next_plant").trigger();
    waitForJob();
  }
  QString openName() { return QFileInfo(document().filePath()).fileName(); }
};

TEST_F(WorklistWindowTest, ListsAFolderWithoutAPlantBeingOpen) {
  writeProject("a.espalier", "Anna");
  QFile::copy(writeScan("b.xyz"), path("plants/b.xyz"));
  chooseFolderOfPlants();
  EXPECT_TRUE(waitForRows({"a.espalier: In review", "b.xyz: To do"}))
      << rows().join(" | ").toStdString();
  EXPECT_TRUE(list().isVisible());
  EXPECT_EQ(cell(0, WorklistModel::annotatorColumn), "Anna");
  EXPECT_EQ(cell(0, WorklistModel::findingsColumn), "–") << "nothing was checked";
  EXPECT_EQ(find<QLabel>("worklist_title").text(), "plants · 2 plants: 1 to do, 1 in review");
  for (int row = 0; row < 2; ++row)
    EXPECT_TRUE(QTest::qWaitFor([&] { return hasPicture(row); }, patience))
        << "picture of row " << row;
  EXPECT_EQ(QDir(path("pictures")).entryList({"*.png"}, QDir::Files).size(), 2);
}

TEST_F(WorklistWindowTest, OpensWhatIsChosenAndTheNextThatIsNotSigned) {
  for (const char* name : {"a.espalier", "b.espalier", "c.espalier"})
    writeProject(name, "Anna");
  chooseFolderOfPlants();
  ASSERT_TRUE(
      waitForRows({"a.espalier: In review", "b.espalier: In review", "c.espalier: In review"}));
  choose(1);
  EXPECT_EQ(openName(), "b.espalier");
  key(Qt::Key_J, Qt::ControlModifier | Qt::ShiftModifier);
  waitForJob();
  EXPECT_EQ(openName(), "c.espalier");
  next();
  EXPECT_EQ(openName(), "a.espalier") << "from the top again";
}

TEST_F(WorklistWindowTest, KeepsItsHeightWhilePlantsComeAndGoAndInTheNextSession) {
  const QString file = writeProject("a.espalier", "Anna");
  chooseFolderOfPlants();
  open({file});
  const auto dock = [this] { return &find<QDockWidget>("worklist"); };
  constexpr int chosen = 330; // [px]
  window().resizeDocks({dock()}, {chosen}, Qt::Vertical);
  const auto hasHeight = [&] {
    return QTest::qWaitFor([&] { return dock()->height() == chosen; }, patience);
  };
  EXPECT_TRUE(hasHeight());
  action("close_plant").trigger();
  waitForJob();
  EXPECT_TRUE(hasHeight()) << "on the start page";
  window().close(); // which keeps the layout
  restart();
  EXPECT_TRUE(hasHeight()) << "in the next session";
  open({file});
  EXPECT_TRUE(hasHeight()) << "with a plant";
}

TEST_F(WorklistWindowTest, FollowsWhatIsDoneToThePlantThatIsOpen) {
  writeProject("a.espalier", "Anna");
  writeProject("b.espalier", "Anna");
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.espalier: In review", "b.espalier: In review"}));
  choose(0);
  document().edit("Review", [](SkeletonEditor& editor) {
    for (const NodeId id : editor.skeleton().ids())
      editor.setReview(id, {.state = ReviewState::reviewed, .reviewer = "Anna"});
  });
  answer(
      [](QDialog& dialog) {
        auto* signer = dialog.findChild<QLineEdit*>("signer");
        signer->selectAll();
        QTest::keyClicks(signer, "Anna");
        dialog.findChild<QLineEdit*>("reason")->setText("as it is");
        press("Sign")(dialog);
      },
      [this] {
        action("sign_structure").trigger();
        waitForJob();
      });
  EXPECT_TRUE(waitForRows({"a.espalier: Signed by Anna", "b.espalier: In review"}))
      << rows().join(" | ").toStdString();
  EXPECT_NE(cell(0, WorklistModel::findingsColumn), "–") << "the seal says so";
  next();
  EXPECT_EQ(openName(), "b.espalier");
  expectNoDialog([this] { action("next_plant").trigger(); });
  EXPECT_EQ(message(), "No other plant that the worklist shows is still to be signed");
  EXPECT_EQ(openName(), "b.espalier");
}

TEST_F(WorklistWindowTest, KnowsTheFindingsOnceTheyWereShown) {
  writeProject("a.espalier", "Anna");
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.espalier: In review"}));
  choose(0);
  action("show_findings").trigger();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return cell(0, WorklistModel::findingsColumn) != "–"; }, patience));
}

TEST_F(WorklistWindowTest, AsksForUnsavedWorkBeforeTheNextPlant) {
  writeProject("a.espalier", "Anna");
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.espalier: In review"}));
  open({writeFork("fork.mtg")});
  edit();
  answer(press("Keep editing"), [this] { next(); });
  EXPECT_EQ(openName(), "fork.mtg");
  answer(press("Discard"), [this] { next(); });
  EXPECT_EQ(openName(), "a.espalier");
}

TEST_F(WorklistWindowTest, OpensAScanAsAPlantOfItsOwn) {
  QFile::copy(writeScan("a.xyz"), path("plants/a.xyz"));
  QFile::copy(path("a.xyz"), path("plants/b.xyz"));
  QFile more(path("plants/b.xyz"));
  ASSERT_TRUE(more.open(QIODevice::Append));
  more.write("0 0 2\n");
  more.close();
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.xyz: To do", "b.xyz: To do"}));
  open({writeFork("fork.mtg")}); // a scan would come under it
  expectNoDialog([this] { next(); });
  EXPECT_EQ(QFileInfo(document().scanPath()).fileName(), "a.xyz");
  EXPECT_TRUE(document().skeleton().isEmpty());
  expectNoDialog([this] { next(); }); // which else asks whether to register it
  EXPECT_EQ(QFileInfo(document().scanPath()).fileName(), "b.xyz");
}

TEST_F(WorklistWindowTest, TakesInFilesThatComeAndLeavesOutThoseThatGo) {
  writeProject("a.espalier", "Anna");
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.espalier: In review"}));
  writeProject("b.espalier", "Ben");
  EXPECT_TRUE(waitForRows({"a.espalier: In review", "b.espalier: In review"}));
  QFile::remove(path("plants/a.espalier"));
  EXPECT_TRUE(waitForRows({"b.espalier: In review"}));
}

TEST_F(WorklistWindowTest, ComparesTwoAnnotatorsOfOneScan) {
  const QString scan = writeScan("plants/scan.xyz");
  writeProject("anna.espalier", "Anna", scan);
  writeProject("ben.espalier", "Ben", scan);
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"anna.espalier: In review", "ben.espalier: In review"}))
      << rows().join(" | ").toStdString();
  EXPECT_EQ(cell(0, WorklistModel::secondColumn), "Ben");
  EXPECT_EQ(cell(1, WorklistModel::secondColumn), "Anna");
  for (int row = 0; row < 2; ++row)
    EXPECT_TRUE(QTest::qWaitFor([&] { return cell(row, WorklistModel::agreementColumn) == "1.00"; },
                                patience))
        << cell(row, WorklistModel::agreementColumn).toStdString();
}

TEST_F(WorklistWindowTest, ComparesTheOpenPlantWithThatOfTheSecondAnnotator) {
  const QString scan = writeScan("plants/scan.xyz");
  writeProject("anna.espalier", "Anna", scan);
  writeProject("ben.espalier", "Ben", scan);
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"anna.espalier: In review", "ben.espalier: In review"}));
  action("compare_second").trigger();
  EXPECT_EQ(message(),
            "The worklist has no project of a second annotator for the plant that is open");
  choose(0);
  action("compare_second").trigger();
  waitForJob();
  EXPECT_EQ(window().part<ReferenceFlow>().name(), "ben.espalier");
  EXPECT_FALSE(window().part<EvaluationFlow>().options().registers) << "both lie in one frame";
}

TEST_F(WorklistWindowTest, ReadsTheListForTheSecondAnnotatorWhileThePanelIsClosed) {
  const QString scan = writeScan("plants/scan.xyz");
  writeProject("anna.espalier", "Anna", scan);
  writeProject("ben.espalier", "Ben", scan);
  expectNoDialog([this] { action("compare_second").trigger(); });
  EXPECT_EQ(message(), "There is no worklist yet: choose a folder or a table for it");
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"anna.espalier: In review", "ben.espalier: In review"}));
  action("show_worklist").trigger();
  window().close();
  restart();
  ASSERT_FALSE(action("show_worklist").isChecked());
  open({path("plants/anna.espalier")});
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        action("compare_second").trigger();
        waitForJob();
        return window().part<ReferenceFlow>().name() == "ben.espalier";
      },
      patience));
}

TEST_F(WorklistWindowTest, PassesOverAPlantThatAnotherWindowWorksOn) {
  for (const char* name : {"a.espalier", "b.espalier", "c.espalier"})
    writeProject(name, "Anna");
  chooseFolderOfPlants();
  ASSERT_TRUE(
      waitForRows({"a.espalier: In review", "b.espalier: In review", "c.espalier: In review"}));
  choose(0);
  auto another = std::make_unique<ProjectLock>(toPath(path("plants/b.espalier")));
  next();
  EXPECT_EQ(openName(), "c.espalier");
  writeProject("d.espalier", "Anna");
  QFile::remove(path("plants/a.espalier"));
  QFile::remove(path("plants/d.espalier"));
  ASSERT_TRUE(waitForRows({"b.espalier: In review", "c.espalier: In review"}));
  expectNoDialog([this] { next(); });
  EXPECT_EQ(message(), "The plants that are still to be signed are open in other windows");
  another.reset();
  next();
  EXPECT_EQ(openName(), "b.espalier");
}

TEST_F(WorklistWindowTest, ShowsABrokenScanAndGoesOn) {
  const std::string good = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\nend_header\n"
                           "0 0 0\n0 0 1\n1 0 1\n";
  std::ofstream(toPath(path("plants/a.ply"))) << "ply\nnonsense\n";
  std::ofstream(toPath(path("plants/b.ply"))) << good;
  writeProject("c.espalier", "Anna");
  chooseFolderOfPlants();
  const auto isRead = [&] {
    return rows().size() == 3 && !rows()[0].endsWith("To do") && rows()[1] == "b.ply: To do";
  };
  ASSERT_TRUE(QTest::qWaitFor(isRead, patience)) << rows().join(" | ").toStdString();
  EXPECT_EQ(list().model()->index(0, 0).data(WorklistModel::stageRole), "p");
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasPicture(1); }, patience)) << "it was read";
  // Broken since, which only opening it shows.
  const std::filesystem::path later = toPath(path("plants/b.ply"));
  const auto time = std::filesystem::last_write_time(later);
  std::ofstream(later) << std::string(good.size(), 'x');
  std::filesystem::last_write_time(later, time);
  next();
  EXPECT_EQ(list().model()->index(1, 0).data(WorklistModel::stageRole), "p");
  next();
  EXPECT_EQ(openName(), "c.espalier") << "not the broken one again";
}

TEST_F(WorklistWindowTest, ShowsThatAProjectIsDamaged) {
  const QString file = writeProject("a.espalier", "Anna");
  Database(toPath(file), Opening::readWrite).execute("UPDATE journal SET delta = x'0102'");
  chooseFolderOfPlants();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return rows().value(0).startsWith("a.espalier: Is damaged: the plant is as it was"); },
      patience))
      << rows().join(" | ").toStdString();
}

TEST_F(WorklistWindowTest, GoesOnAmongLinks) {
  for (const char* name : {"a.espalier", "b.espalier"}) {
    writeProject(name, "Anna");
    QDir().mkpath(path("today"));
    QFile::link(path(QString("plants/") + name), path(QString("today/") + name));
  }
  answer(chooseFile(path("today")), [this] { action("worklist_folder").trigger(); });
  ASSERT_TRUE(waitForRows({"a.espalier: In review", "b.espalier: In review"}));
  next();
  EXPECT_EQ(openName(), "a.espalier");
  next();
  EXPECT_EQ(openName(), "b.espalier");
}

TEST_F(WorklistWindowTest, KnowsAScanThatWasMovedByItsContent) {
  const QString scan = writeScan("plants/scan.xyz");
  writeProject("a.espalier", "Anna", scan);
  ASSERT_TRUE(QDir().rename(path("plants"), path("moved")));
  answer(chooseFile(path("moved")), [this] { action("worklist_folder").trigger(); });
  EXPECT_TRUE(waitForRows({"a.espalier: In review"})) << rows().join(" | ").toStdString();
}

TEST_F(WorklistWindowTest, ShowsWhatIsWrongWithARowAndGoesOn) {
  writeProject("b.espalier", "Anna");
  QFile broken(path("plants/a.espalier"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("no project");
  broken.close();
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows(
      {"a.espalier: Is no project of Espalier: choose another file", "b.espalier: In review"}))
      << rows().join(" | ").toStdString();
  next();
  EXPECT_EQ(openName(), "b.espalier");
}

TEST_F(WorklistWindowTest, FiltersByState) {
  writeProject("a.espalier", "Anna");
  QFile::copy(writeScan("b.xyz"), path("plants/b.xyz"));
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.espalier: In review", "b.xyz: To do"}));
  auto& filter = find<QComboBox>("worklist_filter");
  filter.setCurrentText("To do");
  EXPECT_EQ(rows(), QStringList{"b.xyz: To do"});
  filter.setCurrentText("Signed");
  EXPECT_EQ(rows(), QStringList());
  EXPECT_EQ(find<QLabel>("worklist_note").text(), "No plant of the worklist is in this state.");
  filter.setCurrentText("Not signed");
  EXPECT_EQ(rows().size(), 2);
}

TEST_F(WorklistWindowTest, SortsByAnyColumn) {
  writeProject("a.espalier", "Zoe");
  writeProject("b.espalier", "Ben");
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.espalier: In review", "b.espalier: In review"}));
  list().sortByColumn(WorklistModel::annotatorColumn, Qt::AscendingOrder);
  EXPECT_EQ(cell(0, WorklistModel::annotatorColumn), "Ben");
  list().sortByColumn(WorklistModel::plantColumn, Qt::DescendingOrder);
  EXPECT_EQ(cell(0, WorklistModel::plantColumn), "b.espalier");
}

TEST_F(WorklistWindowTest, ReadsATableWithFurtherColumns) {
  writeProject("a.espalier", "Anna");
  QFile table(path("list.csv"));
  ASSERT_TRUE(table.open(QIODevice::WriteOnly));
  table.write("plot,file,annotator\n7,plants/a.espalier,Zoe\n8,plants/missing.espalier,Zoe\n");
  table.close();
  answer(chooseFile(table.fileName()), [this] { action("worklist_table").trigger(); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return rows().contains("a.espalier: In review"); }, patience));
  EXPECT_EQ(list().model()->headerData(WorklistModel::columns, Qt::Horizontal).toString(), "plot");
  const int row = static_cast<int>(rows().indexOf("a.espalier: In review"));
  EXPECT_EQ(cell(row, WorklistModel::columns), "7");
  EXPECT_EQ(cell(row, WorklistModel::annotatorColumn), "Zoe");
  EXPECT_TRUE(cell(1 - row, WorklistModel::stateColumn)
                  .startsWith("There is no file 'plants/missing.espalier'"))
      << cell(1 - row, WorklistModel::stateColumn).toStdString();
}

TEST_F(WorklistWindowTest, IsThereInTheNextSession) {
  writeProject("a.espalier", "Anna");
  chooseFolderOfPlants();
  ASSERT_TRUE(waitForRows({"a.espalier: In review"}));
  window().close();
  restart();
  EXPECT_TRUE(waitForRows({"a.espalier: In review"}));
}

TEST_F(WorklistWindowTest, SaysWhyAFolderCannotBeListed) {
  chooseFolderOfPlants();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return find<QLabel>("worklist_note").text().contains("holds no project and no scan"); },
      patience));
  writeProject("a.espalier", "Anna");
  EXPECT_TRUE(waitForRows({"a.espalier: In review"})) << "it is looked again";
  EXPECT_FALSE(find<QLabel>("worklist_note").isVisible());
}

TEST_F(WorklistWindowTest, RefusesTheNextPlantWithoutAList) {
  expectNoDialog([this] { action("next_plant").trigger(); });
  EXPECT_EQ(message(), "There is no worklist yet: choose a folder or a table for it");
}

} // namespace
} // namespace espalier
