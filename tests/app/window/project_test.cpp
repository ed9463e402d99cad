#include "app/window/action_set.h"
#include "app/window/load_files.h"
#include "app/window/sessions.h"
#include "app/window/view_text.h"
#include "core/base/error.h"
#include "core/project/project.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QPushButton>
#include <QTest>

#include <gmock/gmock.h>
#include <memory>

namespace espalier {
namespace {

using test::forkTop;

struct ProjectWindowTest : test::WindowTest {
  void setRadius(double radius) {
    document().edit("Radius", [=](SkeletonEditor& editor) { editor.setRadius(forkTop, radius); });
  }
  QString saveProject(const QString& name) {
    const QString file = path(name);
    answer(chooseFile(file), [this] { action("save_project_as").trigger(); });
    return file;
  }
  [[nodiscard]] static History onDisk(const QString& file) {
    return Project::open(toPath(file), Access::readOnly).history().value;
  }
  [[nodiscard]] QStringList sessionFiles() const {
    return QDir(path("sessions")).entryList({"*.espalier"}, QDir::Files);
  }
  [[nodiscard]] PipelineOptions options() {
    return window().findChild<PipelinePanel*>()->options();
  }
  [[nodiscard]] QString message() { return window().banner().text(); }
};

TEST_F(ProjectWindowTest, KeepsPlantScanAndHistoryInAProject) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  setRadius(0.2);
  setRadius(0.3);
  const QString file = saveProject("plant.espalier");
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_TRUE(window().windowTitle().startsWith("plant.espalier"));
  setRadius(0.4);
  document().undoStack().undo();
  EXPECT_EQ(onDisk(file), document().history()) << "saved as it happens";
  EXPECT_FALSE(window().isWindowModified());
  const History before = document().history();
  ASSERT_NE(document().structure().frame, nullptr);
  const std::string mtg = document().structure().frame->text;
  EXPECT_TRUE(window().close()) << "without a question";
  restart();
  open({file});
  ASSERT_NE(document().structure().frame, nullptr);
  EXPECT_EQ(document().structure().frame->text, mtg) << "what an MTG says is kept";
  EXPECT_EQ(document().history(), before);
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().unit(), LengthUnit::meter);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().skeleton()[forkTop].radius, 0.4) << "redo survives";
}

TEST_F(ProjectWindowTest, SaysThatEverythingIsSavedOnSave) {
  open({writeFork("fork.mtg")});
  saveProject("plant.espalier");
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(message(), "Everything is saved");
}

TEST_F(ProjectWindowTest, FindsAProjectSavedByAKilledProgram) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  setRadius(0.7);
  for (const char* ending : {"", "-wal"}) // as the disk is now, so it is after a kill
    QFile::copy(file + ending, path("killed.espalier") + ending);
  restart();
  open({path("killed.espalier")});
  EXPECT_EQ(document().skeleton()[forkTop].radius, 0.7);
  EXPECT_TRUE(document().undoStack().canUndo());
}

TEST_F(ProjectWindowTest, KeepsWorkWithoutANameAndOffersItAtTheNextStart) {
  open({writeScan("puu1.xyz")});
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  EXPECT_EQ(sessionFiles().size(), 1);
  EXPECT_TRUE(window().close()) << "without a question";
  restart();
  EXPECT_TRUE(document().isEmpty());
  EXPECT_TRUE(message().startsWith("Continue with puu1, 1 edit, today "))
      << message().toStdString();
  clickButton("banner_action");
  waitForJob();
  EXPECT_EQ(document().skeleton().size(), 1U);
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_TRUE(document().undoStack().canUndo());
}

TEST_F(ProjectWindowTest, HasASessionReadyBeforeTheFirstEdit) {
  open({writeScan("puu1.xyz")});
  ASSERT_TRUE(QTest::qWaitFor([this] { return !sessionFiles().isEmpty(); }, 60'000));
  const QString file = path("sessions/" + sessionFiles().front());
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  EXPECT_EQ(sessionFiles().size(), 1);
  EXPECT_EQ(onDisk(file), document().history());
}

TEST_F(ProjectWindowTest, LeavesNoSessionBehindOfAPlantThatWasOnlyLookedAt) {
  open({writeScan("puu1.xyz")});
  ASSERT_TRUE(QTest::qWaitFor([this] { return !sessionFiles().isEmpty(); }, 60'000));
  const QString file = path("sessions/" + sessionFiles().front());
  QFile::copy(file, path("killed.espalier"));
  window().close();
  EXPECT_TRUE(sessionFiles().isEmpty());
  QFile::copy(path("killed.espalier"), file); // as if the window had been killed
  restart();
  EXPECT_TRUE(sessionFiles().isEmpty());
  EXPECT_FALSE(window().banner().isVisible());
}

TEST_F(ProjectWindowTest, ForgetsASessionThatIsDiscarded) {
  open({writeScan("puu1.xyz")});
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({}); });
  window().close();
  restart();
  clickButton("banner_other_action");
  EXPECT_TRUE(sessionFiles().isEmpty());
  restart();
  EXPECT_FALSE(window().banner().isVisible());
}

TEST_F(ProjectWindowTest, LeavesNoSessionBehindWhenAllIsSavedInAFile) {
  open({writeFork("fork.mtg")});
  setRadius(0.2);
  EXPECT_EQ(sessionFiles().size(), 1) << "against a crash";
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(window().close());
  EXPECT_TRUE(sessionFiles().isEmpty());
}

TEST_F(ProjectWindowTest, LeavesNoSessionBehindWhenEditsAreDiscarded) {
  open({writeFork("fork.mtg")});
  setRadius(0.2);
  answer(press("Discard"), [this] { EXPECT_TRUE(window().close()); });
  EXPECT_TRUE(sessionFiles().isEmpty());
}

TEST_F(ProjectWindowTest, AsksBeforeAProjectReplacesUnsavedEdits) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  open({path("fork.mtg")}); // which leaves the project
  setRadius(0.2);
  const Skeleton edited = document().skeleton();
  answer(press("Keep editing"), [&] { open({file}); });
  EXPECT_EQ(document().skeleton(), edited);
  EXPECT_EQ(sessionFiles().size(), 1) << "against a crash";
  answer(press("Discard"), [&] { open({file}); });
  EXPECT_EQ(document().skeleton()[forkTop].radius, 0.1);
  EXPECT_TRUE(window().windowTitle().startsWith("plant.espalier"));
  EXPECT_TRUE(sessionFiles().isEmpty()) << "what is discarded is not offered again";
}

TEST_F(ProjectWindowTest, TellsThatAnotherWindowHasTheProjectAndOpensACopy) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  QSettings settings(path("other.ini"), QSettings::IniFormat);
  settings.setValue("sessions_folder", path("other_sessions"));
  MainWindow second(settings);
  second.open({file});
  EXPECT_TRUE(second.banner().isError());
  EXPECT_TRUE(second.banner().text().contains("open in another window"));
  EXPECT_TRUE(second.document().isEmpty());
  second.findChild<QPushButton*>("banner_action")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !second.jobs().isRunning(); }, 60'000));
  EXPECT_EQ(second.document().skeleton(), document().skeleton());
  second.document().edit("Radius", [](SkeletonEditor& editor) { editor.setRadius(forkTop, 9); });
  EXPECT_EQ(onDisk(file), document().history()) << "a copy does not touch it";
}

TEST_F(ProjectWindowTest, OpensAProjectOfAnotherWindowReadOnly) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  setRadius(0.4);
  QSettings settings(path("other.ini"), QSettings::IniFormat);
  settings.setValue("sessions_folder", path("other_sessions"));
  MainWindow second(settings);
  second.open({file});
  second.findChild<QPushButton*>("banner_other_action")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !second.jobs().isRunning(); }, 60'000));
  EXPECT_EQ(second.document().skeleton(), document().skeleton());
  EXPECT_TRUE(second.windowTitle().startsWith("plant.espalier (read-only)"));
  EXPECT_THROW(second.document().edit("Radius",
                                      [](SkeletonEditor& editor) { editor.setRadius(forkTop, 9); }),
               Error);
  second.actionSet()["undo"]->trigger();
  EXPECT_TRUE(second.banner().text().contains("is open read-only: save it as another project"));
  EXPECT_EQ(second.document().skeleton(), document().skeleton());
  EXPECT_FALSE(second.actionSet()["remove"]->isEnabled());
  setRadius(0.5);
  EXPECT_EQ(onDisk(file), document().history()) << "the other window works on";
  EXPECT_TRUE(second.close()) << "without a question";
}

TEST_F(ProjectWindowTest, FindsAScanThatMovedWithTheProject) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  window().close();
  QDir().mkpath(path("moved"));
  QFile::rename(path("plant.xyz"), path("moved/plant.xyz"));
  QFile::rename(path("plant.espalier"), path("moved/plant.espalier"));
  restart();
  open({path("moved/plant.espalier")});
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_FALSE(window().banner().isVisible());
}

TEST_F(ProjectWindowTest, AsksForAScanThatIsGone) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  window().close();
  QDir().mkpath(path("elsewhere"));
  QFile::rename(path("plant.xyz"), path("elsewhere/plant.xyz"));
  restart();
  open({path("plant.espalier")});
  EXPECT_EQ(document().scan(), nullptr);
  EXPECT_EQ(document().skeleton().size(), 5U) << "the plant is there all the same";
  EXPECT_TRUE(message().contains("plant.xyz is not where it was"));
  answer(chooseFile(path("elsewhere/plant.xyz")), [this] { clickButton("banner_action"); });
  waitForJob();
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().skeleton().size(), 5U);
}

TEST_F(ProjectWindowTest, RefusesAnotherScanForTheOneThatIsGone) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  window().close();
  QFile::remove(path("plant.xyz"));
  QFile other(path("other.txt"));
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  other.write("0 0 0\n1 1 1\n");
  other.close();
  restart();
  open({path("plant.espalier")});
  answer(chooseFile(path("other.txt")), [this] { clickButton("banner_action"); });
  waitForJob();
  EXPECT_TRUE(message().contains("is not the scan of this project"));
  EXPECT_EQ(document().scan(), nullptr);
}

TEST_F(ProjectWindowTest, GoesOnWhenItsFileIsRemovedAndSavesElsewhere) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  QFile::remove(file);
  setRadius(0.6);
  EXPECT_TRUE(window().banner().isError());
  EXPECT_TRUE(message().contains("was removed"));
  EXPECT_EQ(document().skeleton()[forkTop].radius, 0.6) << "the edit stands";
  answer(chooseFile(path("rescued.espalier")), [this] { clickButton("banner_action"); });
  EXPECT_EQ(onDisk(path("rescued.espalier")), document().history());
  setRadius(0.7);
  EXPECT_EQ(onDisk(path("rescued.espalier")), document().history());
}

TEST_F(ProjectWindowTest, TakesItsOwnNameAgainWhenItsFileIsRemoved) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  QFile::remove(file);
  setRadius(0.6);
  saveProject("plant.espalier");
  EXPECT_EQ(onDisk(file), document().history());
}

TEST_F(ProjectWindowTest, MarksTheTitleWhileAProjectCannotBeWritten) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  QFile::rename(file, file + ".away");
  setRadius(0.6);
  EXPECT_TRUE(window().isWindowModified());
  document().undoStack().undo();
  EXPECT_TRUE(window().isWindowModified()) << "the file may hold another state";
  QFile::rename(file + ".away", file);
  document().undoStack().redo();
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_EQ(onDisk(file), document().history());
}

TEST_F(ProjectWindowTest, AsksOnClosingWhenAProjectCannotBeWritten) {
  open({writeFork("fork.mtg")});
  QFile::remove(saveProject("plant.espalier"));
  setRadius(0.6);
  answer(press("Keep editing"), [this] { EXPECT_FALSE(window().close()); });
}

TEST_F(ProjectWindowTest, SaysWhatItCouldReadOfADamagedProject) {
  open({writeFork("fork.mtg")});
  setRadius(0.2);
  setRadius(0.3);
  const QString file = saveProject("plant.espalier");
  window().close();
  {
    const Database database(toPath(file), Opening::readWrite);
    database.execute("DELETE FROM snapshot WHERE step > 0");
    database.execute("UPDATE journal SET delta = x'00' WHERE step = 1");
  }
  restart();
  open({file});
  EXPECT_TRUE(window().banner().isError());
  EXPECT_TRUE(message().contains("after 1 of 2 edits"));
  EXPECT_EQ(document().skeleton()[forkTop].radius, 0.2);
  EXPECT_FALSE(action("compact_project").isEnabled()) << "the file is left as it is";
}

TEST_F(ProjectWindowTest, OpensAPlantWhateverIsDamagedBesideIt) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  window().close();
  {
    Project project = Project::open(toPath(file), Access::readWrite);
    project.setBytes("contracted", "no positions");
    project.setDocument("mtg", "no MTG");
  }
  restart();
  open({file});
  EXPECT_EQ(document().skeleton().size(), 5U);
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().contracted(), nullptr);
  EXPECT_TRUE(window().banner().isError());
}

TEST_F(ProjectWindowTest, ShowsNoContractedPointsOfAReconstructionThatIsUndone) {
  open({writeScan("plant.xyz")});
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  ASSERT_NE(document().contracted(), nullptr);
  const QString file = saveProject("plant.espalier");
  restart();
  open({file});
  ASSERT_NE(document().contracted(), nullptr);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().skeleton().isEmpty());
  EXPECT_EQ(document().contracted(), nullptr);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NE(document().contracted(), nullptr);
}

TEST_F(ProjectWindowTest, OffersNoSessionOfWorkThatGotAName) {
  open({writeScan("plant.xyz")});
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  ASSERT_EQ(sessionFiles().size(), 1);
  (void)saveProject("plant.espalier");
  EXPECT_TRUE(sessionFiles().isEmpty());
}

TEST_F(ProjectWindowTest, KeepsTheOptionsOfThePipeline) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  auto& radius = *find<QWidget>("step_contract").findChild<QDoubleSpinBox*>("radius");
  radius.setValue(1.5 * radius.value());
  auto& method = *find<QWidget>("step_clean").findChild<QComboBox*>();
  method.setCurrentIndex(1);
  emit method.activated(1);
  const PipelineOptions chosen = options();
  EXPECT_EQ(chosen.methods.size(), 1U);
  EXPECT_EQ(chosen.settings.at("contract").size(), 1U);
  window().close();
  restart();
  EXPECT_EQ(options(), PipelineOptions()) << "each plant begins with the rules";
  open({file});
  EXPECT_EQ(options(), chosen);
  EXPECT_EQ(find<QWidget>("step_contract").findChild<QDoubleSpinBox*>("radius")->value(),
            chosen.settings.at("contract").at("radius"))
      << "the form shows it";
  open({writeScan("other.xyz")});
  EXPECT_EQ(options(), PipelineOptions()) << "another plant";
}

TEST_F(ProjectWindowTest, KeepsOptionsWhileTheScanIsMissing) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  auto& radius = *find<QWidget>("step_contract").findChild<QDoubleSpinBox*>("radius");
  radius.setValue(1.5 * radius.value());
  const PipelineOptions chosen = options();
  window().close();
  QFile::rename(path("plant.xyz"), path("hidden"));
  ASSERT_TRUE(QFile::resize(path("hidden"), 10));
  restart();
  open({file});
  document().setUnit(LengthUnit::millimeter);
  EXPECT_EQ(options(), chosen) << "not pressed into the range of no plant";
}

TEST_F(ProjectWindowTest, OpensAPlantWhoseOptionsAreOfAnotherProgram) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  window().close();
  Project::open(toPath(file), Access::readWrite)
      .setDocument("pipeline", R"({"contract": {"magic": 1}})");
  restart();
  open({file});
  EXPECT_EQ(document().skeleton().size(), 5U);
  EXPECT_TRUE(window().banner().isError());
  EXPECT_EQ(options(), PipelineOptions());
  setRadius(0.4);
  window().close();
  EXPECT_TRUE(Project::open(toPath(file), Access::readOnly).document("pipeline").find("magic") !=
              std::string::npos)
      << "for that program";
}

TEST_F(ProjectWindowTest, KeepsTheViewAndOpensItWithoutAJump) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  action("view_top").trigger();
  action("parallel").trigger();
  action("layer_points").setChecked(false);
  action("point_size_4").trigger();
  action("color_uniform").trigger();
  waitForView();
  view().setPivot({0.2, 0.1, 0.5});
  waitForView();
  const Camera camera = view().camera();
  window().close();
  restart();
  action("layer_points").setChecked(true);
  action("perspective").trigger();
  action("point_size_1").trigger();
  action("color_height").trigger();
  window().open({file});
  waitForJob();
  EXPECT_EQ(view().camera(), camera);
  waitForView();
  EXPECT_EQ(view().camera(), camera);
  EXPECT_FALSE(action("layer_points").isChecked());
  EXPECT_TRUE(action("parallel").isChecked());
  EXPECT_TRUE(action("point_size_4").isChecked());
  EXPECT_TRUE(action("color_uniform").isChecked());
  open({writeScan("other.xyz")});
  EXPECT_TRUE(action("layer_points").isChecked()) << "another plant is shown as plants were";
  EXPECT_TRUE(action("point_size_1").isChecked());
  EXPECT_EQ(view().camera().projection, Projection::perspective);
}

TEST_F(ProjectWindowTest, ShowsAllOfAPlantWhoseViewCannotBeRead) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const Camera whole = view().camera();
  const QString file = saveProject("plant.espalier");
  window().close();
  Project::open(toPath(file), Access::readWrite)
      .setDocument("view", R"({"camera": {"focus": [0, 0, 1e999], "distance": -1}})");
  restart();
  open({file});
  EXPECT_TRUE(window().banner().isError());
  EXPECT_NEAR(view().camera().distance, whole.distance, 1e-9);
}

TEST(ViewText, BringsAViewBack) {
  const ViewText view{.camera = {.focus = {1.0 / 3, 648'250.001, -2},
                                 .pivot = {0, 1, 2},
                                 .distance = 0.1,
                                 .yaw = -0.3,
                                 .pitch = 1.2,
                                 .projection = Projection::parallel},
                      .layers = {{"layer_points", false}},
                      .choices = {{"color", "color_rgb"}, {"point_size", "point_size_3"}}};
  const ViewText back = viewFrom(textOf(view));
  EXPECT_EQ(back.camera, view.camera) << "to the last bit";
  EXPECT_EQ(back.layers, view.layers);
  EXPECT_EQ(back.choices, view.choices);
}

TEST(ViewText, RefusesACameraThatCannotBe) {
  for (const char* camera :
       {"", R"("distance": 0)", R"("distance": "far")", R"("focus": [1, 2])", R"("pitch": 2)"}) {
    std::string text = textOf({.camera = {.distance = 2}});
    if (*camera == 0)
      text = "{}";
    else // of two equal names the last counts
      text.insert(text.find('}'), std::string(",") + camera);
    EXPECT_THROW((void)viewFrom(text), Error) << text;
  }
}

TEST_F(ProjectWindowTest, KeepsTheScanInTheProject) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  EXPECT_FALSE(action("keep_scan").isEnabled()) << "there is no project yet";
  const QString file = saveProject("plant.espalier");
  const Eigen::Matrix3Xf points = document().scan()->cloud()->positions();
  action("keep_scan").trigger();
  EXPECT_FALSE(action("keep_scan").isChecked()) << "not before it is there";
  waitForJob();
  EXPECT_TRUE(action("keep_scan").isChecked());
  EXPECT_EQ(message(), "plant.espalier holds the scan now");
  window().close();
  QFile::remove(path("plant.xyz"));
  restart();
  open({file});
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().scan()->cloud()->positions(), points);
  EXPECT_FALSE(window().banner().isError());
  EXPECT_TRUE(action("keep_scan").isChecked());
  action("keep_scan").trigger();
  waitForJob();
  EXPECT_TRUE(message().contains("only copy")) << message().toStdString();
  EXPECT_TRUE(action("keep_scan").isChecked());
}

TEST_F(ProjectWindowTest, TakesTheScanOutOfTheProjectWhileItsFileIsThere) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  action("keep_scan").trigger();
  waitForJob();
  action("keep_scan").trigger();
  waitForJob();
  EXPECT_FALSE(action("keep_scan").isChecked());
  window().close();
  EXPECT_FALSE(Project::open(toPath(file), Access::readOnly).hasBytes("cloud"));
}

TEST_F(ProjectWindowTest, LeavesTheProjectAsItWasWhenKeepingTheScanIsCanceled) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  action("keep_scan").trigger();
  window().jobs().cancel();
  waitForJob();
  EXPECT_FALSE(action("keep_scan").isChecked());
  EXPECT_FALSE(Project::open(toPath(file), Access::readOnly).hasBytes("cloud"));
}

TEST_F(ProjectWindowTest, KeepsTheScanInAProjectSavedUnderAnotherName) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  action("keep_scan").trigger();
  waitForJob();
  const QString other = saveProject("other.espalier");
  window().close();
  EXPECT_TRUE(Project::open(toPath(other), Access::readOnly).hasBytes("cloud"));
}

TEST_F(ProjectWindowTest, CompactsAProject) {
  open({writeFork("fork.mtg")});
  EXPECT_FALSE(action("compact_project").isEnabled());
  const QString file = saveProject("plant.espalier");
  setRadius(0.6);
  ASSERT_TRUE(action("compact_project").isEnabled());
  action("compact_project").trigger();
  EXPECT_TRUE(message().startsWith("plant.espalier is "));
  EXPECT_EQ(onDisk(file), document().history());
}

TEST_F(ProjectWindowTest, ExportsACopyAndStaysInTheProject) {
  open({writeFork("fork.mtg")});
  saveProject("plant.espalier");
  answer(chooseFile(path("copy.mtg")), [this] { key(Qt::Key_E, Qt::ControlModifier); });
  EXPECT_TRUE(QFile::exists(path("copy.mtg")));
  EXPECT_TRUE(document().filePath().endsWith("plant.espalier"));
}

TEST_F(ProjectWindowTest, LeavesTheProjectAsItIsWhenAnotherPlantIsOpened) {
  open({writeFork("fork.mtg")});
  setRadius(0.6);
  const QString file = saveProject("plant.espalier");
  const History before = document().history();
  open({writeFork("other.mtg")});
  setRadius(0.9);
  EXPECT_EQ(onDisk(file), before);
  EXPECT_TRUE(document().filePath().endsWith("other.mtg"));
}

TEST(Session, IsDescribedAsPeopleWould) {
  const QDateTime now(QDate(2026, 11, 21), QTime(12, 0));
  const QString time = QLocale().toString(QTime(17, 3), QLocale::ShortFormat);
  Session session{
      .name = "puu1", .edits = 14, .last = QDateTime(QDate(2026, 11, 20), QTime(17, 3))};
  EXPECT_EQ(describe(session, now), "puu1, 14 edits, yesterday " + time);
  session.edits = 1;
  session.last = QDateTime(QDate(2026, 11, 21), QTime(17, 3));
  EXPECT_EQ(describe(session, now), "puu1, 1 edit, today " + time);
}

} // namespace
} // namespace espalier
