// How a plant without scales of its own is saved as an MTG.
#include "core/mtg/mtg_reader.h"
#include "tests/app/window/window_fixture.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QTest>

#include <fstream>
#include <map>

namespace espalier {
namespace {

struct SaveStyleTest : test::WindowTest {
  /// Chooses the type of file of this list whose text holds `part`, and a name.
  static std::function<void(QDialog&)> chooseAs(const QString& part, const QString& path) {
    return [part, path](QDialog& dialog) {
      auto& files = dynamic_cast<QFileDialog&>(dialog);
      for (const QString& filter : files.nameFilters())
        if (filter.contains(part)) files.selectNameFilter(filter);
      EXPECT_TRUE(files.selectedNameFilter().contains(part));
      chooseFile(path)(dialog);
    };
  }
  [[nodiscard]] std::map<int, int> verticesPerScale(const QString& name) const {
    std::ifstream in(path(name).toStdString());
    std::map<int, int> counts;
    for (const MtgVertex& vertex : readMtg(in, name.toStdString()).value.vertices)
      ++counts[vertex.scale];
    return counts;
  }
  // test::fork(3): five nodes; an axis from the root, and one of each of two branching shoots.
  const std::map<int, int> plantNode = {{1, 1}, {2, 5}};
  const std::map<int, int> plantAxisNode = {{1, 1}, {2, 3}, {3, 5}};
};

TEST_F(SaveStyleTest, TheTypeOfFileSetsWhetherThereAreAxes) {
  open({writeFork("fork.txt")});
  answer(chooseAs("as PlantScan3D", path("nodes.mtg")), [this] { action("save_as").trigger(); });
  EXPECT_EQ(verticesPerScale("nodes.mtg"), plantNode);
  answer(chooseAs("plant, axes and nodes", path("axes.mtg")),
         [this] { action("save_as").trigger(); });
  EXPECT_EQ(verticesPerScale("axes.mtg"), plantAxisNode);
}

TEST_F(SaveStyleTest, SavingAgainKeepsTheFormOfTheFile) {
  open({writeFork("fork.txt")});
  answer(chooseAs("plant, axes and nodes", path("axes.mtg")),
         [this] { action("save_as").trigger(); });
  edit();
  expectNoDialog([this] { action("save").trigger(); });
  EXPECT_FALSE(document().isModified());
  EXPECT_EQ(verticesPerScale("axes.mtg"), plantAxisNode);
  answer(chooseAs("as PlantScan3D", path("copy.mtg")),
         [this] { action("export_structure").trigger(); });
  EXPECT_EQ(verticesPerScale("copy.mtg"), plantNode);
  edit();
  action("save").trigger();
  EXPECT_EQ(verticesPerScale("axes.mtg"), plantAxisNode)
      << "a copy in another form changes nothing";
}

TEST_F(SaveStyleTest, TheTypeOfFileDecidesWhereOthersHaveTheSameExtension) {
  open({writeFork("fork.mtg")});
  const auto formatWritten = [this](const QString& name) {
    return formatOf(toPath(path(name))).name;
  };
  answer(chooseAs("TreeQSM", path("table.txt")), [this] { action("export_structure").trigger(); });
  EXPECT_EQ(formatWritten("table.txt"), "QSM table");
  EXPECT_EQ(window().statusLine().shownText(), "Exported table.txt");
  answer(chooseAs("RayCloudTools", path("tree.txt")),
         [this] { action("export_structure").trigger(); });
  EXPECT_EQ(formatWritten("tree.txt"), "treefile");
  open({path("table.txt")});
  edit();
  expectNoDialog([this] { action("save").trigger(); });
  EXPECT_EQ(formatWritten("table.txt"), "QSM table") << "it stays what it was";
}

TEST_F(SaveStyleTest, TheFormChosenLastIsProposedNextTime) {
  open({writeFork("fork.txt")});
  answer(chooseAs("plant, axes and nodes", path("axes.mtg")),
         [this] { action("save_as").trigger(); });
  restart();
  open({writeFork("other.txt")});
  answer(chooseFile(path("other.mtg")), [this] { action("save_as").trigger(); });
  EXPECT_EQ(verticesPerScale("other.mtg"), plantAxisNode);
}

TEST_F(SaveStyleTest, AFileWithScalesKeepsThemAndIsNotAsked) {
  open({writeFork("fork.mtg")});
  answer(
      [this](QDialog& dialog) {
        const auto& files = dynamic_cast<QFileDialog&>(dialog);
        EXPECT_EQ(files.nameFilters().filter("*.mtg").size(), 1);
        chooseFile(path("copy.mtg"))(dialog);
      },
      [this] { action("save_as").trigger(); });
  EXPECT_EQ(verticesPerScale("copy.mtg"), plantNode);
}

TEST_F(SaveStyleTest, TheNameFollowsTheTypeThatIsChosen) {
  open({writeFork("fork.txt")});
  QStringList names;
  answer(
      [&](QDialog& dialog) {
        auto& files = dynamic_cast<QFileDialog&>(dialog);
        const auto name = [&] { return QFileInfo(files.selectedFiles().value(0)).fileName(); };
        names.append(name());
        EXPECT_TRUE(files.selectedNameFilter().contains("*.txt"));
        auto* types = dialog.findChild<QComboBox*>("fileTypeCombo");
        ASSERT_NE(types, nullptr);
        QApplication::setActiveWindow(&dialog); // or its keys go to the view
        for (const char* part : {"plant, axes and nodes", "lines.obj", "as PlantScan3D"}) {
          types->setFocus();
          const int row = types->findText(part, Qt::MatchContains);
          QTest::keyClick(types, Qt::Key_Home);
          for (int i = 0; i < row; ++i)
            QTest::keyClick(types, Qt::Key_Down);
          names.append(name());
        }
        files.reject();
      },
      [this] { action("save_as").trigger(); });
  EXPECT_EQ(names, (QStringList{"fork.txt", "fork.mtg", "fork.lines.obj", "fork.mtg"}));
}

} // namespace
} // namespace espalier
