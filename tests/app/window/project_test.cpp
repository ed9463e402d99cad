#include "app/window/files/sessions.h"
#include "app/window/frame/action_set.h"
#include "app/window/review/findings_flow.h"
#include "core/base/error.h"
#include "tests/app/window/project_fixture.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

namespace espalier {
namespace {

using test::forkTop;
using test::ProjectWindowTest;

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

TEST_F(ProjectWindowTest, IsSavedUnderTheEndingByWhichProjectsAreKnown) {
  open({writeFork("fork.mtg")});
  saveProject("anna.esp");
  EXPECT_FALSE(QFile::exists(path("anna.esp")));
  EXPECT_TRUE(QFile::exists(path("anna.esp.espalier")));
  open({writeFork("other.mtg")});
  const auto before = QFileInfo(path("anna.esp.espalier")).size();
  saveProject("anna.esp");
  EXPECT_TRUE(window().banner().text().contains("anna.esp.espalier is there already"))
      << window().banner().text().toStdString();
  EXPECT_EQ(QFileInfo(path("anna.esp.espalier")).size(), before);
}

TEST_F(ProjectWindowTest, SaysWhoseStepsAreRecordedInAProjectOfAnother) {
  const auto type = [this](const QString& name) {
    auto& reviewer = find<QLineEdit>("reviewer");
    reviewer.setText(name);
    emit reviewer.editingFinished();
  };
  const auto add = [this] {
    document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  };
  open({writeScan("anna.xyz")});
  type("Anna");
  add();
  const QString file = saveProject("anna.espalier");
  type("Ben");
  open({writeScan("other.xyz")});
  open({file});
  const QString text = "This project is by Anna: your steps will be recorded as by Ben";
  EXPECT_EQ(message(), text);
  open({path("other.xyz")});
  add();
  open({file});
  EXPECT_TRUE(message().startsWith(text + "\nYour work is kept: ")) << message().toStdString();
  EXPECT_EQ(find<QPushButton>("banner_other_action").text(), "Go Back to It");
  clickButton("banner_action");
  add();
  EXPECT_EQ(onDisk(file).steps.back().author, "Anna");
  open({writeScan("third.xyz")});
  open({file});
  EXPECT_FALSE(message().contains("recorded") && window().banner().isVisible());
}

TEST_F(ProjectWindowTest, SaysThatEverythingIsSavedOnSave) {
  open({writeFork("fork.mtg")});
  saveProject("plant.espalier");
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(message(), "Everything is saved in plant.espalier");
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
  const QString folder = QFileInfo(path("puu1.xyz")).dir().dirName();
  EXPECT_TRUE(message().startsWith("Continue with puu1 in " + folder + ", 1 edit, today "))
      << message().toStdString();
  clickButton("banner_action");
  waitForJob();
  EXPECT_EQ(document().skeleton().size(), 1U);
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_TRUE(document().undoStack().canUndo());
}

TEST_F(ProjectWindowTest, OffersWorkOnAScanWhenThatIsOpenedAgain) {
  const QString scan = writeScan("puu1.xyz");
  const QString other = writeScan("puu2.xyz");
  open({scan});
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  EXPECT_TRUE(window().close());
  restart();
  open({other});
  EXPECT_FALSE(window().banner().isVisible());
  open({scan});
  EXPECT_TRUE(message().startsWith("Work on this plant was kept: puu1 in "))
      << message().toStdString();
  EXPECT_TRUE(document().skeleton().isEmpty());
  clickButton("banner_action");
  waitForJob();
  EXPECT_EQ(document().skeleton().size(), 1U);
}

TEST_F(ProjectWindowTest, SaysThatWorkIsKeptWhereAnotherPlantIsOpenedAndGoesBackToIt) {
  open({writeScan("puu1.xyz")});
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  open({writeScan("puu2.xyz")});
  EXPECT_TRUE(message().startsWith("Your work is kept: puu1 in ")) << message().toStdString();
  EXPECT_TRUE(document().skeleton().isEmpty());
  clickButton("banner_action");
  waitForJob();
  EXPECT_EQ(document().skeleton().size(), 1U);
  EXPECT_TRUE(document().scanPath().endsWith("puu1.xyz"));
  open({path("puu2.xyz")});
  EXPECT_TRUE(message().startsWith("Your work is kept: puu1 in ")) << "again, as there is some";
  open({path("puu2.xyz")});
  EXPECT_FALSE(window().banner().isVisible()) << "nothing was done to this one";
}

TEST_F(ProjectWindowTest, SaysThatWorkIsKeptWhereAProjectIsOpened) {
  open({writeScan("puu1.xyz")});
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  saveProject("named.espalier");
  open({writeScan("puu2.xyz")});
  EXPECT_FALSE(window().banner().isVisible()) << "a project has a name";
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  open({path("named.espalier")});
  EXPECT_TRUE(message().startsWith("Your work is kept: puu2 in ")) << message().toStdString();
}

TEST_F(ProjectWindowTest, HasASessionReadyBeforeTheFirstEdit) {
  open({writeScan("puu1.xyz")});
  ASSERT_TRUE(QTest::qWaitFor([this] { return !sessionFiles().isEmpty(); }, patience));
  const QString file = path("sessions/" + sessionFiles().front());
  document().edit("Add", [](SkeletonEditor& editor) { editor.add({.radius = 0.5}); });
  EXPECT_EQ(sessionFiles().size(), 1);
  EXPECT_EQ(onDisk(file), document().history());
}

TEST_F(ProjectWindowTest, LeavesNoSessionBehindOfAPlantThatWasOnlyLookedAt) {
  open({writeScan("puu1.xyz")});
  ASSERT_TRUE(QTest::qWaitFor([this] { return !sessionFiles().isEmpty(); }, patience));
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

TEST_F(ProjectWindowTest, KeepsAReviewThatTheFileCannotHold) {
  const QString file = writeFork("fork.mtg");
  open({file});
  document().edit("Comment", [](SkeletonEditor& editor) {
    editor.setReview(forkTop, {.state = ReviewState::doubtful, .comment = "a spur?"});
  });
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(window().close()) << "without a question: nothing is lost";
  EXPECT_EQ(sessionFiles().size(), 1);
  restart();
  open({file});
  EXPECT_EQ(document().skeleton()[forkTop].review, ReviewMark()) << "the file alone has none";
  EXPECT_TRUE(message().startsWith("Work on this plant was kept: fork")) << message().toStdString();
  clickButton("banner_action");
  waitForJob();
  EXPECT_EQ(document().skeleton()[forkTop].review.comment, "a spur?");
}

// Of a plant that nobody has edited, too.
TEST_F(ProjectWindowTest, KeepsWhatIsIgnoredOfAPlantInNoProject) {
  const QString file = openWithAFinding();
  restart();
  EXPECT_TRUE(sessionFiles().isEmpty());
  open({file});
  ASSERT_EQ(document().undoStack().count(), 0);
  const auto ignored = [this] { return window().part<FindingsFlow>().ignored().size(); };
  key(Qt::Key_F8);
  key(Qt::Key_F4);
  key(Qt::Key_F4, Qt::ControlModifier);
  ASSERT_EQ(ignored(), 1U);
  EXPECT_TRUE(window().close()) << "without a question: nothing is lost";
  EXPECT_EQ(sessionFiles().size(), 1);
  restart();
  open({file});
  EXPECT_EQ(ignored(), 0U);
  EXPECT_TRUE(message().startsWith("Work on this plant was kept: fork")) << message().toStdString();
  clickButton("banner_action");
  waitForJob();
  EXPECT_TRUE(QTest::qWaitFor([&] { return ignored() == 1U; }, patience));
  window().close();
  EXPECT_EQ(sessionFiles().size(), 1) << "it is still to be kept";
}

TEST_F(ProjectWindowTest, LeavesNoSessionBehindOfWhatIsIgnoredNoMore) {
  const QString file = openWithAFinding();
  key(Qt::Key_F8);
  key(Qt::Key_F4);
  key(Qt::Key_F4, Qt::ControlModifier);
  ASSERT_EQ(window().part<FindingsFlow>().ignored().size(), 1U);
  auto& kinds = find<QComboBox>("findings_kind");
  kinds.setCurrentIndex(kinds.findText("Ignored", Qt::MatchStartsWith));
  emit kinds.activated(kinds.currentIndex());
  key(Qt::Key_F4);
  key(Qt::Key_F4, Qt::ControlModifier);
  ASSERT_EQ(window().part<FindingsFlow>().ignored().size(), 0U);
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

TEST_F(ProjectWindowTest, SaysThatAnotherWindowHasTheProjectAndOpensACopy) {
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
  ASSERT_TRUE(QTest::qWaitFor([&] { return !second.jobs().isBusy(); }, patience));
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
  ASSERT_TRUE(QTest::qWaitFor([&] { return !second.jobs().isBusy(); }, patience));
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
  const QString time = "17:03";
  Session session{
      .name = "puu1", .edits = 14, .last = QDateTime(QDate(2026, 11, 20), QTime(17, 3))};
  EXPECT_EQ(describe(session, now), "puu1, 14 edits, yesterday " + time);
  session.edits = 1;
  session.last = QDateTime(QDate(2026, 11, 21), QTime(17, 3));
  EXPECT_EQ(describe(session, now), "puu1, 1 edit, today " + time);
  session.name = "scan";
  session.scan = "/birches/puu1/scan.ply";
  EXPECT_EQ(describe(session, now), "scan in puu1, 1 edit, today " + time);
}

} // namespace
} // namespace espalier
