#include "app/window/files/load_files.h"
#include "core/io/atomic_file.h"
#include "core/io/formats.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/message_banner.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QTimer>

namespace espalier {
namespace {

using test::forkTop;

using WindowFilesTest = test::WindowTest;

TEST_F(WindowFilesTest, SaysWhatIsWrongWithAFileInOneLine) {
  QFile file(path("broken.xyz"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("no numbers here\n");
  file.close();
  open({path("broken.xyz")});
  EXPECT_TRUE(window().banner().isVisible());
  EXPECT_TRUE(window().banner().isError());
  EXPECT_TRUE(window().banner().text().contains("broken.xyz"));
  EXPECT_FALSE(window().banner().text().contains('\n'));
  EXPECT_TRUE(document().isEmpty());
}

TEST_F(WindowFilesTest, KeepsThePlantWhenTheNextFileCannotBeRead) {
  open({writeFork("fork.mtg")});
  open({path("missing.mtg")});
  EXPECT_TRUE(window().banner().isError());
  EXPECT_EQ(document().skeleton().size(), 5U);
}

TEST_F(WindowFilesTest, KeepsTheEditsWhenTheDiskIsFull) {
  if (!QFile::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  open({writeFork("fork.mtg")});
  edit();
  const QString full = path("full.mtg");
  ASSERT_TRUE(QFile::link("/dev/full", full));
  document().undoStack().resetClean();
  document().markSaved(full); // as if it had been saved there
  edit();
  document().edit("Move again", [](SkeletonEditor& editor) {
    editor.setPosition(forkTop, {1, 1, 1});
  });
  const Skeleton edited = document().skeleton();
  action("save").trigger();
  EXPECT_TRUE(window().banner().isError());
  EXPECT_TRUE(document().isModified());
  EXPECT_EQ(document().skeleton(), edited);
}

TEST_F(WindowFilesTest, AsksBeforeUnsavedEditsAreLost) {
  open({writeFork("fork.mtg")});
  edit();
  answer(press("Keep editing"), [this] { EXPECT_FALSE(window().close()); });
  EXPECT_TRUE(window().isVisible());
  answer(press("Discard"), [this] { EXPECT_TRUE(window().close()); });
  EXPECT_FALSE(window().isVisible());
}

TEST_F(WindowFilesTest, OffersAProjectForWhatTheFileCannotHold) {
  open({writeFork("fork.mtg")});
  document().edit("Comment",
                  [](SkeletonEditor& editor) { editor.setReview(forkTop, {.comment = "dead"}); });
  answer(
      [](QDialog& dialog) {
        const QString text = dynamic_cast<QMessageBox&>(dialog).informativeText();
        EXPECT_TRUE(text.contains("keeps no review")) << text.toStdString();
        const QPushButton* usual = dynamic_cast<QMessageBox&>(dialog).defaultButton();
        EXPECT_TRUE(usual != nullptr && usual->text() == "Save Project As…") << "loses nothing";
        press("Keep editing")(dialog);
      },
      [this] { EXPECT_FALSE(window().close()); });
  const QString project = path("fork.espalier");
  QTimer timer; // names the file that is asked for next
  QObject::connect(&timer, &QTimer::timeout, [&] {
    if (auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
      timer.stop();
      chooseFile(project)(*files);
    }
  });
  timer.start(0);
  answer(press("Save Project As…"), [this] { EXPECT_TRUE(window().close()); });
  restart();
  open({project});
  EXPECT_EQ(document().skeleton()[nodeAt({0, 0, 1})].review.comment, "dead");
}

TEST_F(WindowFilesTest, SavesBeforeItClosesIfAsked) {
  open({writeFork("fork.mtg")});
  edit();
  const Eigen::Vector3d place = document().skeleton()[forkTop].position;
  answer(press("Save"), [this] { EXPECT_TRUE(window().close()); });
  restart();
  open({path("fork.mtg")});
  nodeAt(place);
}

TEST_F(WindowFilesTest, ClosesWithoutAQuestionIfNothingIsLost) {
  open({writeFork("fork.mtg")});
  edit();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(window().close());
}

TEST_F(WindowFilesTest, AsksNothingBeforeAFileThatCannotBeRead) {
  open({writeFork("fork.mtg")});
  edit();
  const Skeleton edited = document().skeleton();
  for (const char* name : {"broken.mtg", "broken.espalier"}) {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("CODE :\tFORM-A\nno more\n");
    file.close();
    expectNoDialog([&] { open({path(name)}); });
    EXPECT_TRUE(window().banner().isError());
    EXPECT_TRUE(window().banner().text().contains(name));
    EXPECT_EQ(document().skeleton(), edited);
    EXPECT_TRUE(document().isModified());
  }
}

TEST_F(WindowFilesTest, AsksBeforeAnotherSkeletonReplacesUnsavedEdits) {
  open({writeFork("fork.mtg")});
  edit();
  const Skeleton edited = document().skeleton();
  writeFork("other.mtg");
  answer(press("Keep editing"), [this] { open({path("other.mtg")}); });
  EXPECT_EQ(document().skeleton(), edited);
  EXPECT_EQ(document().filePath(), path("fork.mtg"));
  EXPECT_TRUE(document().isModified());
  answer(press("Discard"), [this] { open({path("other.mtg")}); });
  EXPECT_EQ(document().filePath(), path("other.mtg"));
  EXPECT_FALSE(document().isModified());
}

TEST_F(WindowFilesTest, SavesUnsavedEditsBeforeAnotherSkeletonReplacesThem) {
  open({writeFork("fork.mtg")});
  edit();
  const Eigen::Vector3d place = document().skeleton()[forkTop].position;
  writeFork("other.mtg");
  answer(press("Save"), [this] { open({path("other.mtg")}); });
  EXPECT_EQ(document().filePath(), path("other.mtg"));
  open({path("fork.mtg")});
  nodeAt(place);
}

TEST_F(WindowFilesTest, KeepsThePlantWhoseEditsCannotBeSavedForAnother) {
  if (!QFile::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  open({writeFork("fork.mtg")});
  const QString full = path("full.mtg");
  ASSERT_TRUE(QFile::link("/dev/full", full));
  document().markSaved(full); // as if it had been saved there
  edit();
  const Skeleton edited = document().skeleton();
  answer(press("Save"), [this] { open({path("fork.mtg")}); });
  EXPECT_TRUE(window().banner().isError());
  EXPECT_EQ(document().skeleton(), edited);
  EXPECT_TRUE(document().isModified());
}

// Coarser scales with values of their own, a column that the editor does not know, odd numbers.
TEST_F(WindowFilesTest, ChangesInAFileOfOthersTheCoordinatesOfTheMovedNodeOnly) {
  const QByteArray head = "CODE :\tFORM-A\n\nCLASSES :\n"
                          "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
                          "$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\tFREE\tFREE\tEXPLICIT\n"
                          "A\t2\tFREE\tFREE\tEXPLICIT\nE\t3\tFREE\tFREE\tEXPLICIT\n\n"
                          "DESCRIPTION :\nLEFT\tRIGHT\tRELTYPE\tMAX\nE\tE\t+\t?\n\n"
                          "FEATURES :\nNAME\tTYPE\nXX\tREAL\nYY\tREAL\nZZ\tREAL\n"
                          "Color\tALPHA\nMTG :\nENTITY-CODE\t\tXX\tYY\tZZ\tColor\n"
                          "/P1\t\t\t\t\told\n^/A1\t\t\t\t\tbrown\n"
                          "^/E1\t\t0\t0\t0.00\tred\n^<E2\t\t0\t0\t1.0\t\n";
  const QByteArray tail = "\t+A2/E3\t1e0\t0\t2.50\tgreen\n";
  QFile file(path("others.mtg"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(head + "^<E4\t\t0\t0\t2.0\tblue\n" + tail);
  file.close();
  open({path("others.mtg")});
  ASSERT_EQ(document().skeleton().size(), 4U);
  const NodeId moved = nodeAt({0, 0, 2});
  const QPoint from = placeOf(moved);
  drag(from, from + QPoint(40, 10));
  ASSERT_GT((document().skeleton()[moved].position - Eigen::Vector3d(0, 0, 2)).norm(), 0.01);
  key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray saved = file.readAll();
  EXPECT_TRUE(saved.startsWith(head + "^<E4\t\t")) << saved.toStdString();
  EXPECT_TRUE(saved.endsWith("\tblue\n" + tail)) << saved.toStdString();
  const QList<QByteArray> row = saved.mid(head.size()).chopped(tail.size()).split('\t');
  ASSERT_EQ(row.size(), 6);
  EXPECT_EQ(Eigen::Vector3d(row[2].toDouble(), row[3].toDouble(), row[4].toDouble()),
            document().skeleton()[moved].position);
}

TEST_F(WindowFilesTest, KeepsACopyOfAFileOfOthersThatItOverwrites) {
  open({writeFork("fork.mtg")});
  QFile before(path("fork.mtg"));
  ASSERT_TRUE(before.open(QIODevice::ReadOnly));
  const QByteArray content = before.readAll();
  for (const double height : {3.0, 4.0}) {
    document().edit("Move", [=](SkeletonEditor& editor) {
      editor.setPosition(forkTop, {0, 0, height});
    });
    key(Qt::Key_S, Qt::ControlModifier);
  }
  QFile copy(path("fork.mtg~"));
  ASSERT_TRUE(copy.open(QIODevice::ReadOnly));
  EXPECT_EQ(copy.readAll(), content);
}

TEST_F(WindowFilesTest, RemovesWhatAKilledRunLeftUnfinishedWhereItSaves) {
  QProcess run; // one that has ended
  run.start("true", {});
  ASSERT_TRUE(run.waitForStarted());
  const qint64 ended = run.processId();
  ASSERT_TRUE(run.waitForFinished());
  QString left;
  writeAtomically(toPath(path("oak.mtg")), [&](std::ostream&) {
    left = QDir(path({})).entryList({".oak.mtg.*"}, QDir::Files | QDir::Hidden).value(0);
  });
  left.replace(QString("-%1-").arg(QCoreApplication::applicationPid()), QString("-%1-").arg(ended));
  ASSERT_TRUE(QFile::copy(path("oak.mtg"), path(left)));
  open({writeFork("fork.txt")});
  answer(chooseFile(path("fork.mtg")), [this] { action("save_as").trigger(); });
  EXPECT_FALSE(QFile::exists(path(left)));
}

TEST_F(WindowFilesTest, SaysWhatTheFormatOfAFileDoesNotKeep) {
  open({writeFork("fork.mtg")});
  edit();
  answer(chooseFile(path("fork.swc")), [this] { action("save_as").trigger(); });
  EXPECT_FALSE(document().isModified());
  EXPECT_TRUE(window().banner().isVisible());
  EXPECT_FALSE(window().banner().isError());
  EXPECT_TRUE(window().banner().text().contains("SWC keeps no edge types"));
}

TEST_F(WindowFilesTest, SaysThatAnMtgKeepsNoReview) {
  open({writeFork("fork.mtg")});
  document().edit(
      "Comment", [](SkeletonEditor& editor) { editor.setReview(forkTop, {.comment = "a spur?"}); });
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(document().isModified());
  EXPECT_TRUE(window().banner().text().contains("MTG keeps no review"))
      << qPrintable(window().banner().text());
}

TEST_F(WindowFilesTest, LeavesThePlantUnsavedInAFormatThatCannotBeOpened) {
  open({writeFork("fork.mtg")});
  edit();
  answer(chooseFile(path("fork.lines.obj")), [this] { action("save_as").trigger(); });
  EXPECT_TRUE(QFile::exists(path("fork.lines.obj")));
  EXPECT_TRUE(document().isModified());
  EXPECT_EQ(document().filePath(), path("fork.mtg"));
}

TEST_F(WindowFilesTest, OpensFilesThatAreDropped) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(writeFork("fork.mtg"))});
  QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &drop);
  EXPECT_TRUE(QTest::qWaitFor([this] { return document().skeleton().size() == 5; }, patience));
}

TEST_F(WindowFilesTest, PutsASkeletonOverItsScanAndAnotherScanInPlaceOfBoth) {
  open({writeScan("plant.xyz")});
  open({writeFork("fork.mtg")});
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().skeleton().size(), 5U);
  open({writeScan("other.xyz")});
  EXPECT_TRUE(document().skeleton().isEmpty());
  EXPECT_TRUE(document().scanPath().endsWith("other.xyz"));
}

TEST_F(WindowFilesTest, GuessesTheUnitOfAStructureWithoutAScan) {
  writeStructure(toPath(path("tall.mtg")), test::stick(21, 150)); // 3000 high
  writeStructure(toPath(path("dot.mtg")), test::stick(1));
  open({path("tall.mtg")});
  EXPECT_EQ(document().unit(), LengthUnit::millimeter);
  open({writeFork("fork.mtg")});
  EXPECT_EQ(document().unit(), LengthUnit::meter) << "it is another plant";
  open({path("dot.mtg")});
  EXPECT_EQ(document().unit(), LengthUnit::unknown);
}

TEST_F(WindowFilesTest, TakesTheUnitOfTheScanForAStructureOverIt) {
  open({writeScan("plant.xyz")});
  writeStructure(toPath(path("tall.mtg")), test::stick(21, 150));
  open({path("tall.mtg")});
  EXPECT_EQ(document().unit(), LengthUnit::meter);
}

TEST_F(WindowFilesTest, ForgetsThePlantThatIsClosed) {
  open({writeFork("fork.mtg")});
  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_TRUE(document().isEmpty());
  EXPECT_FALSE(find<QDockWidget>("pipeline").isVisible());
}

} // namespace
} // namespace espalier
