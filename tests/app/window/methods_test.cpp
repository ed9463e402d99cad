#include "app/window/evaluate/methods_text.h"
#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/skeleton/edits.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/methods_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

namespace espalier {
namespace {

/// The fork of three shoots as reference; methods that found one, two and all of them.
struct MethodsWindowTest : test::ProjectWindowTest {
  QString write(int shoots) {
    const QString file = path(QStringLiteral("method%1.mtg").arg(shoots));
    Skeleton plant = test::fork(3);
    SkeletonEditor editor(plant);
    for (int i = shoots; i < 3; ++i)
      removeSubtree(editor, NodeId{static_cast<std::uint32_t>(2 + i)});
    static_cast<void>(editor.commit());
    writeStructure(toPath(file), plant);
    return file;
  }
  void openWithReference() {
    open({write(2)});
    answer(chooseFile(write(3)), [this] { action("load_reference").trigger(); });
    waitForJob();
    key(Qt::Key_F5, Qt::ShiftModifier);
  }
  void showTable() {
    if (!action("show_methods").isChecked()) action("show_methods").trigger();
  }
  void add(const QString& file) {
    answer(chooseFile(file), [this] { clickButton("methods_add"); });
  }
  QTableWidget& table() { return find<QTableWidget>("methods_table"); }
  [[nodiscard]] QString cell(int row, const QString& column) {
    for (int i = 0; i < table().columnCount(); ++i)
      if (table().horizontalHeaderItem(i)->text() == column) return table().item(row, i)->text();
    return "no such column";
  }
  [[nodiscard]] bool waitForRows(int count) {
    return QTest::qWaitFor(
        [&] {
          if (table().rowCount() != count) return false;
          for (int row = 0; row < count; ++row)
            if (cell(row, "F") == QStringLiteral("…")) return false;
          return true;
        },
        patience);
  }
};

TEST_F(MethodsWindowTest, NeedsAReferenceFirst) {
  open({write(2)});
  key(Qt::Key_F5, Qt::ShiftModifier);
  EXPECT_EQ(table().rowCount(), 0);
  EXPECT_FALSE(find<QPushButton>("methods_add").isEnabled());
  EXPECT_TRUE(find<QLabel>("methods_note").text().startsWith("Load a reference first"));
}

TEST_F(MethodsWindowTest, ComparesAnyNumberOfStructuresTheBestFirst) {
  openWithReference();
  ASSERT_TRUE(waitForRows(1));
  EXPECT_EQ(cell(0, "Structure"), "The plant");
  add(write(1));
  add(write(3));
  ASSERT_TRUE(waitForRows(3));
  EXPECT_EQ(cell(0, "Structure"), "method3.mtg");
  EXPECT_EQ(cell(1, "Structure"), "The plant");
  EXPECT_EQ(cell(2, "Structure"), "method1.mtg");
  EXPECT_EQ(cell(0, "F"), "1.000");
  EXPECT_EQ(cell(2, "Precision"), "1.000");
  // A trunk of 1 and shoots of sqrt 2: what it has, and the tolerance along each shoot it lacks.
  EXPECT_NEAR(cell(2, "Recall").toDouble(), (1 + std::sqrt(2.0)) / (1 + 3 * std::sqrt(2.0)), 0.2);
  EXPECT_EQ(cell(2, "Nodes"), "3");
  EXPECT_EQ(cell(0, "Edit distance"), "0");
  table().sortItems(1, Qt::AscendingOrder);
  EXPECT_EQ(cell(0, "Structure"), "method1.mtg");
}

TEST_F(MethodsWindowTest, FollowsTheReferenceAndTheTolerance) {
  openWithReference();
  add(write(1));
  ASSERT_TRUE(waitForRows(2));
  const QString before = cell(1, "Recall");
  auto& tolerance = find<QWidget>("evaluation_tolerance");
  tolerance.setProperty("value", 30.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return cell(1, "Recall") == "1.000"; }, patience));
  EXPECT_NE(before, "1.000");
  action("remove_reference").trigger();
  EXPECT_EQ(table().rowCount(), 0);
}

TEST_F(MethodsWindowTest, AFileThatCannotBeReadStopsNoneOfTheOthers) {
  openWithReference();
  QFile broken(path("broken.mtg"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("nonsense");
  broken.close();
  add(path("broken.mtg"));
  add(write(1));
  ASSERT_TRUE(waitForRows(3));
  EXPECT_EQ(cell(2, "Structure"), QStringLiteral("⚠ broken.mtg"));
  EXPECT_TRUE(table().item(2, 0)->toolTip().contains("broken.mtg"));
  EXPECT_EQ(cell(2, "F"), QStringLiteral("–"));
  EXPECT_EQ(cell(1, "Structure"), "method1.mtg");
}

TEST_F(MethodsWindowTest, IsKeptInTheProjectWithItsNumbers) {
  openWithReference();
  add(write(1));
  add(write(3));
  ASSERT_TRUE(waitForRows(3));
  const QString recall = cell(2, "Recall");
  const QString file = saveProject("plant.espalier");
  QFile::remove(path("method3.mtg"));
  restart();
  open({file});
  showTable();
  ASSERT_TRUE(waitForRows(3));
  EXPECT_EQ(cell(2, "Structure"), "method1.mtg");
  EXPECT_EQ(cell(2, "Recall"), recall);
  EXPECT_EQ(cell(0, "Structure"), QStringLiteral("⚠ method3.mtg"));
  EXPECT_EQ(cell(0, "F"), "1.000") << "as it was when the file was there";
  EXPECT_TRUE(table().item(0, 0)->toolTip().contains("is not where it was"));
}

TEST_F(MethodsWindowTest, ComparesAnewWhatWasWrittenSinceTheProject) {
  openWithReference();
  add(write(1));
  ASSERT_TRUE(waitForRows(2));
  const QString file = saveProject("plant.espalier");
  writeStructure(toPath(path("method1.mtg")), test::fork(3));
  QFile written(path("method1.mtg"));
  ASSERT_TRUE(written.open(QIODevice::ReadWrite));
  written.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime);
  written.close();
  restart();
  open({file});
  showTable();
  ASSERT_TRUE(waitForRows(2));
  EXPECT_EQ(cell(0, "Structure"), "method1.mtg");
  EXPECT_EQ(cell(0, "Recall"), "1.000");
}

TEST_F(MethodsWindowTest, OfOneProjectIsNotThatOfTheNext) {
  openWithReference();
  add(write(1));
  ASSERT_TRUE(waitForRows(2));
  saveProject("first.espalier");
  open({write(2)});
  EXPECT_EQ(table().rowCount(), 2) << "another skeleton of the plant";
  action("close_plant").trigger();
  open({write(2)});
  answer(chooseFile(write(3)), [this] { action("load_reference").trigger(); });
  waitForJob();
  EXPECT_TRUE(waitForRows(1));
}

TEST(MethodsText, ComesBackAsItWas) {
  ScoreValues values;
  for (const Score& score : scores())
    values[score.key] = 0.25;
  values["shift"] = std::nullopt;
  const std::vector<KeptMethod> kept = {
      {.path = "/a/b.mtg", .scores = values, .written = 1'700'000'000'123},
      {.path = "c.mtg", .scores = std::nullopt}};
  EXPECT_EQ(methodsFrom(textOf(kept)), kept);
  EXPECT_EQ(textOf(std::vector<KeptMethod>()), "");
  EXPECT_TRUE(methodsFrom("").empty());
}

TEST(MethodsText, LeavesOutScoresOfAnotherVersion) {
  const auto read = methodsFrom(R"([{"path": "a.mtg", "written": 5, "scores": {"f": 0.5}}])");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_FALSE(read.front().scores.has_value()) << "it is compared again";
}

TEST(MethodsText, IsRefusedIfItIsNone) {
  for (const char* text : {"nonsense", "{}", "[{}]", R"([{"path": 3}])",
                           R"([{"path": "a.mtg", "scores": {"f": "much"}}])"})
    EXPECT_THROW(static_cast<void>(methodsFrom(text)), Error) << text;
}

TEST_F(MethodsWindowTest, IsCopiedAndLetsGoOfRows) {
  openWithReference();
  add(write(1));
  ASSERT_TRUE(waitForRows(2));
  table().setFocus();
  QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
  const QStringList lines = QApplication::clipboard()->text().split('\n');
  ASSERT_EQ(lines.size(), 4) << "head, two rows, and the end";
  EXPECT_TRUE(lines[0].startsWith("Structure\tF\tPrecision\tRecall"));
  EXPECT_TRUE(lines[2].startsWith("method1.mtg\t0."));
  EXPECT_EQ(lines[2].count('\t'), lines[0].count('\t'));
  table().selectRow(0);
  clickButton("methods_remove");
  EXPECT_EQ(table().rowCount(), 2) << "the plant stays";
  table().selectRow(1);
  clickButton("methods_remove");
  EXPECT_EQ(table().rowCount(), 1);
}

} // namespace
} // namespace espalier
