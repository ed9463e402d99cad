#include "tests/support/plants.h"
#include "ui/document/plant_document.h"
#include "ui/panels/node_table_model.h"

#include <QLocale>
#include <QSignalSpy>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;

struct NodeTableModelTest : testing::Test {
  PlantDocument document;
  NodeTableModel model{document};

  void SetUp() override {
    document.openSkeleton(test::stick(4), "stick.mtg");
    document.edit("Radii", [](SkeletonEditor& editor) {
      editor.setRadius(NodeId{0}, 4);
      editor.setRadius(NodeId{1}, 10);
      editor.setRadius(NodeId{2}, 2.5);
      editor.setRadius(NodeId{3}, 4);
    });
    model.update();
  }
  QModelIndex cell(int row, NodeColumn column) {
    return model.index(row, static_cast<int>(column));
  }
  QString text(int row, NodeColumn column) {
    return cell(row, column).data(Qt::DisplayRole).toString();
  }
  std::vector<unsigned> order() {
    std::vector<unsigned> ids;
    for (int row = 0; row < model.rowCount(); ++row)
      ids.push_back(static_cast<unsigned>(model.node(row)));
    return ids;
  }
};

TEST_F(NodeTableModelTest, ShowsWhatANodeIs) {
  document.setUnit(LengthUnit::millimeter);
  EXPECT_EQ(text(2, NodeColumn::node), "2");
  EXPECT_EQ(text(2, NodeColumn::parent), "1");
  EXPECT_EQ(text(2, NodeColumn::edge), "<");
  EXPECT_EQ(text(2, NodeColumn::order), "0");
  EXPECT_EQ(text(2, NodeColumn::axis), "1");
  EXPECT_EQ(text(2, NodeColumn::z), "2.0000");
  EXPECT_EQ(text(2, NodeColumn::radius), "2.5000");
  EXPECT_EQ(text(2, NodeColumn::length), "1.0000");
  EXPECT_EQ(text(2, NodeColumn::source), "by hand");
  EXPECT_EQ(text(2, NodeColumn::most), "");
  EXPECT_EQ(text(2, NodeColumn::review), "to do");
  EXPECT_EQ(text(0, NodeColumn::parent), "") << "a root has none";
  EXPECT_EQ(text(0, NodeColumn::length), "");
  EXPECT_EQ(model.headerData(static_cast<int>(NodeColumn::radius), Qt::Horizontal, Qt::DisplayRole),
            "Radius [mm]");
}

TEST_F(NodeTableModelTest, SortsByAnyColumnAndKeepsTheOrderOfEqualOnes) {
  model.sort(static_cast<int>(NodeColumn::radius), Qt::AscendingOrder);
  EXPECT_THAT(order(), ElementsAre(2, 0, 3, 1)) << "by number, not as text";
  model.sort(static_cast<int>(NodeColumn::radius), Qt::DescendingOrder);
  EXPECT_THAT(order(), ElementsAre(1, 0, 3, 2));
  model.sort(static_cast<int>(NodeColumn::node), Qt::DescendingOrder);
  EXPECT_THAT(order(), ElementsAre(3, 2, 1, 0));
  model.sort(static_cast<int>(NodeColumn::parent), Qt::DescendingOrder);
  EXPECT_THAT(order(), ElementsAre(3, 2, 1, 0)) << "the root, which has none, is last";
}

TEST_F(NodeTableModelTest, FindsTheRowOfANode) {
  model.sort(static_cast<int>(NodeColumn::radius), Qt::AscendingOrder);
  EXPECT_EQ(model.row(NodeId{3}), 2);
  model.setFilter(NodeFilter("radius > 3"));
  EXPECT_EQ(model.row(NodeId{2}), std::nullopt);
  EXPECT_EQ(model.row(NodeId{99}), std::nullopt);
  EXPECT_THAT(order(), ElementsAre(0, 3, 1));
}

TEST_F(NodeTableModelTest, ListsSomeNodesOnRequest) {
  model.show(std::vector{NodeId{3}, NodeId{1}});
  EXPECT_THAT(order(), ElementsAre(1, 3));
  model.show(std::nullopt);
  EXPECT_EQ(model.rowCount(), 4);
}

TEST_F(NodeTableModelTest, ForgetsNodesThatAreGone) {
  document.edit("Remove", [](SkeletonEditor& editor) { editor.erase(NodeId{3}); });
  EXPECT_EQ(text(3, NodeColumn::radius), "") << "until it is updated";
  EXPECT_FALSE(model.flags(cell(3, NodeColumn::radius)).testFlag(Qt::ItemIsEditable));
  model.update();
  EXPECT_THAT(order(), ElementsAre(0, 1, 2));
}

TEST_F(NodeTableModelTest, KeepsItsRowsWhileOnlyCellsChange) {
  const QSignalSpy resets(&model, &NodeTableModel::modelReset);
  const QSignalSpy changes(&model, &NodeTableModel::dataChanged);
  document.edit("Radius", [](SkeletonEditor& editor) { editor.setRadius(NodeId{1}, 11); });
  model.update();
  EXPECT_EQ(resets.size(), 0) << "where one has scrolled to stays";
  EXPECT_GE(changes.size(), 1);
  EXPECT_EQ(text(1, NodeColumn::radius), "11.000");
}

TEST_F(NodeTableModelTest, ReportsWhatIsTyped) {
  double radius = 0;
  QObject::connect(&model, &NodeTableModel::radiusTyped,
                   [&](NodeId id, double typed) { radius = id == NodeId{1} ? typed : -1; });
  EXPECT_TRUE(model.setData(cell(1, NodeColumn::radius), "12.5", Qt::EditRole));
  EXPECT_EQ(radius, 12.5);
  EXPECT_EQ(document.skeleton()[NodeId{1}].radius, 10) << "a model edits nothing";
  EdgeType edge = EdgeType::successor;
  QObject::connect(&model, &NodeTableModel::edgeChosen,
                   [&](NodeId, EdgeType chosen) { edge = chosen; });
  EXPECT_TRUE(model.setData(cell(1, NodeColumn::edge), "+", Qt::EditRole));
  EXPECT_EQ(edge, EdgeType::branching);
}

TEST_F(NodeTableModelTest, RefusesWhatIsNoRadius) {
  const QSignalSpy refusals(&model, &NodeTableModel::refused);
  const QSignalSpy radii(&model, &NodeTableModel::radiusTyped);
  for (const char* text : {"", "thick", "-1", "nan", "inf", "1 2"})
    EXPECT_FALSE(model.setData(cell(1, NodeColumn::radius), text, Qt::EditRole)) << text;
  EXPECT_EQ(refusals.size(), 6);
  EXPECT_EQ(radii.size(), 0);
}

TEST_F(NodeTableModelTest, LetsOnlyRadiiAndEdgesBeChanged) {
  const auto isEditable = [&](int row, NodeColumn column) {
    return model.flags(cell(row, column)).testFlag(Qt::ItemIsEditable);
  };
  EXPECT_TRUE(isEditable(1, NodeColumn::radius));
  EXPECT_TRUE(isEditable(1, NodeColumn::edge));
  EXPECT_FALSE(isEditable(0, NodeColumn::edge)) << "a root is attached to nothing";
  EXPECT_FALSE(isEditable(1, NodeColumn::x));
  document.setReadOnly("it is another window's");
  EXPECT_FALSE(isEditable(1, NodeColumn::radius));
}

TEST_F(NodeTableModelTest, WritesATableThatASpreadsheetReads) {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German)); // which writes 2,5
  document.setUnit(LengthUnit::meter);
  document.edit("Comment", [](SkeletonEditor& editor) {
    editor.setReview(NodeId{2}, {ReviewState::reviewed, "two\tcells,\ntwo lines", "Ada"});
  });
  const QStringList lines = model.tableOf({NodeId{2}, NodeId{0}}).split('\n');
  QLocale::setDefault(before);
  ASSERT_EQ(lines.size(), 4) << "each line ends";
  EXPECT_EQ(lines[0], "node\tparent\tedge\torder\taxis\tx [m]\ty [m]\tz [m]\tradius [m]\t"
                      "length [m]\tclass\tindex\tmark\treview\tcomment\t"
                      "radius_source\tradius_least [m]\tradius_most [m]");
  EXPECT_EQ(lines[1],
            "2\t1\t<\t0\t1\t0\t0\t2\t2.5\t1\t\t\t\treviewed\ttwo cells, two lines\tby hand\t\t");
  EXPECT_EQ(lines[2], "0\t\t\t0\t1\t0\t0\t0\t4\t\t\t\t\tto do\t\tby hand\t\t");
}

} // namespace
} // namespace espalier
