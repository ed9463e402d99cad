#include "app/report/comparison_report.h"
#include "app/window/files/load_files.h"
#include "core/io/formats.h"
#include "core/skeleton/edits.h"
#include "tests/app/window/project_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/status_line.h"

#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QTest>
#include <QToolButton>

namespace espalier {
namespace {

struct ReportWindowTest : test::ProjectWindowTest {
  QString write(const QString& name, const Skeleton& skeleton) {
    writeStructure(toPath(path(name)), skeleton);
    return path(name);
  }
  /// A stick of one edge less than its reference.
  void compare() {
    open({write("plant.mtg", test::stick(20, 0.1))});
    answer(chooseFile(write("expert.mtg", test::stick(21, 0.1))),
           [this] { action("load_reference").trigger(); });
    waitForJob();
  }
  [[nodiscard]] bool waitForNote(const QString& note) {
    return QTest::qWaitFor([&] { return window().statusLine().shownText().startsWith(note); },
                           patience);
  }
  [[nodiscard]] QByteArray bytesOf(const QString& file) {
    QFile in(file);
    EXPECT_TRUE(in.open(QIODevice::ReadOnly)) << qPrintable(file);
    return in.readAll();
  }
};

TEST_F(ReportWindowTest, IsThereOnceThereIsAReference) {
  EXPECT_FALSE(action("export_report").isEnabled());
  open({write("plant.mtg", test::stick(20, 0.1))});
  EXPECT_FALSE(action("export_report").isEnabled());
  answer(chooseFile(write("expert.mtg", test::stick(21, 0.1))),
         [this] { action("load_reference").trigger(); });
  waitForJob();
  EXPECT_TRUE(action("export_report").isEnabled());
  EXPECT_FALSE(action("export_report").statusTip().isEmpty());
  EXPECT_TRUE(find<QToolButton>("evaluation_report").isVisible());
  action("remove_reference").trigger();
  EXPECT_FALSE(action("export_report").isEnabled());
}

TEST_F(ReportWindowTest, IsWrittenByTheButtonOfTheDock) {
  compare();
  document().edit("Move node", [](SkeletonEditor& editor) {
    editor.setPosition(NodeId{19}, {0, 0, 1.95});
  });
  const QString file = path("plant.report.html");
  answer(chooseFile(file), [this] { find<QToolButton>("evaluation_report").click(); });
  EXPECT_TRUE(waitForNote("Drawing the pictures of plant.report.html"));
  ASSERT_TRUE(waitForNote("Wrote plant.report.html"))
      << qPrintable(window().statusLine().shownText());
  EXPECT_EQ(message(), "Wrote plant.report.html") << "until one has seen it";
  EXPECT_TRUE(window().banner().isVisible());
  EXPECT_FALSE(window().banner().leavesByItself());
  const QString html = QString::fromUtf8(bytesOf(file));
  EXPECT_TRUE(html.contains("<h1>plant.mtg compared with expert.mtg</h1>"));
  EXPECT_TRUE(html.contains("Work by hand"));
  EXPECT_TRUE(html.contains("1 edit, under a minute of work"));
  EXPECT_TRUE(action("export_report").isEnabled()) << "again";
}

TEST_F(ReportWindowTest, IsOfferedTheNameOfTheScanIfThePlantHasNone) {
  open({writeScan("oak.xyz")});
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  answer(chooseFile(write("expert.mtg", test::stick(21, 0.1))),
         [this] { action("load_reference").trigger(); });
  waitForJob();
  answer(
      [this](QDialog& dialog) {
        auto& files = dynamic_cast<QFileDialog&>(dialog);
        EXPECT_EQ(files.selectedFiles(), QStringList(path("oak.report.html")));
        files.reject();
      },
      [this] { action("export_report").trigger(); });
}

// Found again, the shift would be another, though too small a one to move the reference.
TEST_F(ReportWindowTest, ReportsThePlantWhereThePanelLaysIt) {
  open({write("plant.mtg", test::stick(21, 0.1))});
  answer(chooseFile(write("expert.mtg", test::stick(21, 0.1))),
         [this] { action("load_reference").trigger(); });
  waitForJob();
  const auto isShown = [this](const QString& text) {
    return QTest::qWaitFor([&] { return find<QLabel>("evaluation_shift").text() == text; },
                           patience);
  };
  ASSERT_TRUE(isShown(QStringLiteral("moved by 0\u202fm")))
      << qPrintable(find<QLabel>("evaluation_shift").text());
  document().edit("Move all", [](SkeletonEditor& editor) { moveAll(editor, {0.001, 0, 0}); });
  answer(chooseFile(path("plant.html")), [this] { action("export_report").trigger(); });
  ASSERT_TRUE(waitForNote("Wrote plant.html"));
  const QString html = QString::fromUtf8(bytesOf(path("plant.html")));
  EXPECT_TRUE(html.contains("the plant was moved to lie on the reference"));
  EXPECT_TRUE(html.contains("--shift=0,0,0")) << "and so does the command";
  EXPECT_TRUE(isShown(QStringLiteral("moved by 0\u202fm")));
}

TEST_F(ReportWindowTest, NamesTheScanAndItsHashWhileTheFileIsThere) {
  const QString scan = writeScan("tree.xyz");
  open({scan});
  compare();
  const QString hash = reportedFile(toPath(scan)).fingerprint;
  for (const bool isThere : {true, false}) {
    if (!isThere) QFile::remove(scan);
    const QString name = isThere ? "there.html" : "gone.html";
    answer(chooseFile(path(name)), [this] { action("export_report").trigger(); });
    ASSERT_TRUE(waitForNote("Wrote " + name)) << qPrintable(window().statusLine().shownText());
    const QString html = QString::fromUtf8(bytesOf(path(name)));
    EXPECT_TRUE(html.contains("tree.xyz"));
    EXPECT_EQ(html.contains(hash), isThere);
    EXPECT_EQ(html.contains("the file can no longer be read"), !isThere);
  }
}

TEST_F(ReportWindowTest, ListsApartWhatIsIgnored) {
  Skeleton twig = test::stick(21, 0.1);
  twig.add({.position = {0.7, 0, 1}, .parent = NodeId{10}, .edge = EdgeType::branching});
  open({write("plant.mtg", test::stick(21, 0.1))});
  answer(chooseFile(write("expert.mtg", twig)), [this] { action("load_reference").trigger(); });
  waitForJob();
  ASSERT_TRUE(QTest::qWaitFor(
      [this] { return find<QLabel>("differences_title").text() == "1 error"; }, patience));
  key(Qt::Key_F3);
  key(Qt::Key_F3, Qt::ControlModifier);
  answer(chooseFile(path("plant.html")), [this] { action("export_report").trigger(); });
  ASSERT_TRUE(waitForNote("Wrote plant.html"));
  EXPECT_TRUE(bytesOf(path("plant.html")).contains("1 more was looked at and is ignored"));
}

TEST_F(ReportWindowTest, IsAPdfIfItsNameSaysSo) {
  compare();
  answer(chooseFile(path("plant.pdf")), [this] { action("export_report").trigger(); });
  ASSERT_TRUE(waitForNote("Wrote plant.pdf"));
  EXPECT_TRUE(bytesOf(path("plant.pdf")).startsWith("%PDF-"));
}

TEST_F(ReportWindowTest, IsRefusedWhereItCannotBeWritten) {
  compare();
  answer(chooseFile(path("plant.docx")), [this] { action("export_report").trigger(); });
  EXPECT_TRUE(message().contains("a report is written as HTML or PDF")) << qPrintable(message());
  EXPECT_FALSE(QFile::exists(path("plant.docx")));
}

TEST_F(ReportWindowTest, LeavesNothingWhereItIsCanceled) {
  compare();
  answer(chooseFile(path("plant.html")), [this] { action("export_report").trigger(); });
  clickButton("cancel_job");
  EXPECT_TRUE(QTest::qWaitFor([this] { return action("export_report").isEnabled(); }, patience));
  QTest::qWait(0);
  EXPECT_FALSE(QFile::exists(path("plant.html")));
}

} // namespace
} // namespace espalier
