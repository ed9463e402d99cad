// A plant without its shape in the window: there is nothing to see in space, but all to read.
#include "tests/app/window/window_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QFile>
#include <QLabel>
#include <QTest>
#include <QTreeView>

namespace espalier {
namespace {

struct ShapelessWindowTest : test::WindowTest {
  QByteArray typed = QByteArray::fromStdString(
      "CODE :\tFORM-A\nCLASSES :\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
      "P\t1\tFREE\tFREE\tEXPLICIT\nS\t2\tFREE\tFREE\tEXPLICIT\nFEATURES :\nNAME\tTYPE\n"
      "Length\tREAL\n\nMTG :\nENTITY-CODE\t\t\tLength\n/P1\t\t\t9\n\t/S1\t\t5\n\t\t+S1.1\t2 # "
      "dead\n"
      "\t\t+S1.2\t1\n\t^<S2\t\t4\n");

  QString write(const QString& name, const QByteArray& bytes) {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    return path(name);
  }
  [[nodiscard]] QByteArray bytesOf(const QString& name) const {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  }
  QString cell(const QModelIndex& row, int column) {
    return row.siblingAtColumn(column).data().toString();
  }
};

TEST_F(ShapelessWindowTest, ShowsScalesAndFeatures) {
  open({write("typed.mtg", typed)});
  auto& tree = find<QTreeView>("vertex_tree");
  ASSERT_TRUE(tree.isVisible());
  EXPECT_FALSE(view().isVisible());
  EXPECT_EQ(find<QLabel>("vertex_headline").text(), "typed.mtg has no positions");
  EXPECT_EQ(find<QLabel>("vertex_counts").text(),
            "Scale 1: 1 P  ·  Scale 2: 4 S  ·  Edges: 1 <, 2 +");
  EXPECT_TRUE(window().statusLine().counts().contains("5 vertices"));
  const QModelIndex plant = tree.model()->index(0, 0);
  EXPECT_EQ(cell(plant, 0), "P1");
  ASSERT_EQ(tree.model()->rowCount(plant), 4);
  const QModelIndex shoot = tree.model()->index(2, 0, plant);
  EXPECT_EQ(cell(shoot, 0), "S1.2");
  EXPECT_EQ(cell(shoot, 1), "2");
  EXPECT_EQ(cell(shoot, 2), "+ S1");
  EXPECT_EQ(cell(shoot, 3), "1");
}

TEST_F(ShapelessWindowTest, IsSavedAsItWas) {
  open({write("typed.mtg", typed)});
  ASSERT_TRUE(action("save").isEnabled());
  action("save").trigger();
  EXPECT_EQ(bytesOf("typed.mtg"), typed);
  answer(chooseFile(path("copy.mtg")), [this] { action("save_as").trigger(); });
  EXPECT_EQ(bytesOf("copy.mtg"), typed);
  answer(chooseFile(path("copy.opf")), [this] { action("export_structure").trigger(); });
  EXPECT_TRUE(bytesOf("copy.opf").contains("<branch class=\"S\" scale=\"2\""));
}

TEST_F(ShapelessWindowTest, SaysWhatNeedsPositions) {
  open({write("typed.mtg", typed)});
  answer(chooseFile(path("copy.swc")), [this] { action("export_structure").trigger(); });
  EXPECT_TRUE(find<MessageBanner>("message_banner").text().contains("SWC needs positions"));
  EXPECT_FALSE(QFile::exists(path("copy.swc")));
}

TEST_F(ShapelessWindowTest, GivesWayToAPlantWithPositions) {
  open({write("typed.mtg", typed)});
  open({writeFork("fork.mtg")});
  EXPECT_FALSE(find<QTreeView>("vertex_tree").isVisible());
  EXPECT_TRUE(view().isVisible());
}

TEST_F(ShapelessWindowTest, GivesWayToWhatIsNoMtg) {
  open({write("typed.mtg", typed)});
  open({writeFork("fork.txt")});
  EXPECT_TRUE(view().isVisible());
  answer(chooseFile(path("fork.espalier")), [this] { action("save_project_as").trigger(); });
  open({path("typed.mtg")});
  ASSERT_TRUE(find<QTreeView>("vertex_tree").isVisible());
  open({path("fork.espalier")});
  EXPECT_TRUE(view().isVisible());
  EXPECT_FALSE(window().statusLine().counts().contains("vert"));
  open({path("typed.mtg")});
  action("new_plant").trigger();
  EXPECT_FALSE(find<QTreeView>("vertex_tree").isVisible());
  EXPECT_FALSE(window().statusLine().counts().contains("vert"));
}

TEST_F(ShapelessWindowTest, ComesBackFromAProject) {
  open({write("typed.mtg", typed)});
  answer(chooseFile(path("plant.espalier")), [this] { action("save_project_as").trigger(); });
  restart();
  open({path("plant.espalier")});
  EXPECT_TRUE(find<QTreeView>("vertex_tree").isVisible());
  EXPECT_EQ(find<QLabel>("vertex_headline").text(), "plant.espalier has no positions");
  answer(chooseFile(path("again.mtg")), [this] { action("export_structure").trigger(); });
  EXPECT_EQ(bytesOf("again.mtg"), typed);
}

} // namespace
} // namespace espalier
