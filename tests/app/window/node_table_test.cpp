#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/node_facts.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QTranslator>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;

struct NodeTableWindowTest : test::WindowTest {
  void openTable() {
    open({writeFork("fork.mtg")});
    key(Qt::Key_F11);
    QCoreApplication::processEvents(); // the dock takes its place
  }
  QTableView& table() { return find<QTableView>("node_table"); }
  QModelIndex cell(NodeId id, NodeColumn column) {
    for (int row = 0; row < table().model()->rowCount(); ++row)
      if (table().model()->index(row, 0).data().toULongLong() == indexOf(id))
        return table().model()->index(row, static_cast<int>(column));
    ADD_FAILURE() << "no row of node " << indexOf(id);
    return {};
  }
  QPoint placeOfCell(NodeId id, NodeColumn column) {
    table().scrollTo(cell(id, column));
    return table().visualRect(cell(id, column)).center();
  }
  void clickRow(NodeId id, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(table().viewport(), Qt::LeftButton, modifiers,
                      placeOfCell(id, NodeColumn::parent));
  }
  template <class Editor> Editor* edit(NodeId id, NodeColumn column) {
    const QPoint place = placeOfCell(id, column);
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, place);
    return table().viewport()->findChild<Editor*>();
  }
  void typeFilter(const QString& text) {
    auto& field = find<QLineEdit>("node_filter");
    field.setFocus();
    field.clear();
    QTest::keyClicks(&field, text);
  }
  QString count() { return find<QLabel>("node_count").text(); }
  std::vector<NodeId> chosen() { return document().selection().nodes(); }
};

TEST_F(NodeTableWindowTest, ListsAllNodes) {
  openTable();
  EXPECT_TRUE(find<QDockWidget>("node_table").isVisible());
  EXPECT_EQ(table().model()->rowCount(), 5);
  EXPECT_EQ(count(), "5 of 5 nodes, 0 selected");
}

TEST_F(NodeTableWindowTest, CutsNoNameOfAColumn) {
  const auto expectRoom = [this](const char* longest) {
    open({writeFork("fork.mtg")});
    action("show_node_table").setChecked(true);
    QCoreApplication::processEvents();
    document().setUnit(LengthUnit::millimeter);
    const QHeaderView* header = table().horizontalHeader();
    QStringList names;
    for (int column = 0; column < nodeColumns; ++column) {
      names << table().model()->headerData(column, Qt::Horizontal).toString();
      EXPECT_GE(header->sectionSize(column),
                header->fontMetrics().horizontalAdvance(names.back()) + 10)
          << names.back().toStdString();
    }
    EXPECT_TRUE(names.contains(longest)) << names.join(", ").toStdString();
  };
  expectRoom("Length [mm]");
  QTranslator french;
  ASSERT_TRUE(french.load("espalier_fr", ":/translations"));
  QApplication::installTranslator(&french);
  restart();
  expectRoom("Longueur [mm]");
  QApplication::removeTranslator(&french);
}

TEST_F(NodeTableWindowTest, HasRoomForCommentsInAWindowOfCommonSize) {
  openTable();
  document().setUnit(LengthUnit::millimeter);
  QHeaderView* header = table().horizontalHeader();
  constexpr int comment = static_cast<int>(NodeColumn::comment);
  EXPECT_GE(header->sectionSize(comment),
            header->fontMetrics().horizontalAdvance("broken, see photo"));
  EXPECT_LE(header->sectionViewportPosition(comment) + header->sectionSize(comment),
            table().viewport()->width());
}

TEST_F(NodeTableWindowTest, SaysWhyItIsEmpty) {
  open({writeScan("plant.xyz")});
  key(Qt::Key_F11);
  EXPECT_EQ(count(), "There are no nodes yet");
  open({writeFork("fork.mtg")});
  find<QCheckBox>("only_selected").click();
  EXPECT_EQ(count(), "Select nodes to list them");
  document().selection().set({forkTop});
  EXPECT_EQ(count(), "1 of 5 nodes, 1 selected");
}

TEST_F(NodeTableWindowTest, TheArrowOfTheOrderDoesNotLieOnTheName) {
  openTable();
  QHeaderView* header = table().horizontalHeader();
  const QRect section(0, 0, header->sectionSize(0), header->height());
  const QImage marked = header->grab(section).toImage();
  header->setSortIndicatorShown(false);
  const QImage plain = header->grab(section).toImage();
  const auto boundsOf = [&](const auto& isOf) {
    QRect bounds;
    for (int y = 0; y < section.height() - 2; ++y) // without the line below
      for (int x = 0; x < section.width(); ++x)
        if (isOf(x, y)) bounds |= QRect(x, y, 1, 1);
    return bounds;
  };
  const QRgb ground = plain.pixel(1, 1);
  const QRect text = boundsOf([&](int x, int y) { return plain.pixel(x, y) != ground; });
  const QRect arrow =
      boundsOf([&](int x, int y) { return marked.pixel(x, y) != plain.pixel(x, y); });
  EXPECT_FALSE(text.isEmpty());
  EXPECT_GE(arrow.width(), 4);
  EXPECT_FALSE(arrow.intersects(text));
}

TEST_F(NodeTableWindowTest, RowsSelectNodes) {
  openTable();
  clickRow(forkTop);
  EXPECT_THAT(chosen(), ElementsAre(forkTop));
  clickRow(forkRoot, Qt::ControlModifier);
  EXPECT_THAT(chosen(), ElementsAre(forkTop, forkRoot)) << "the one clicked last is last";
  EXPECT_EQ(count(), "5 of 5 nodes, 2 selected");
}

TEST_F(NodeTableWindowTest, NodesSelectRows) {
  openTable();
  click(placeOf(forkTop));
  ASSERT_THAT(chosen(), ElementsAre(forkTop));
  EXPECT_TRUE(table().selectionModel()->isRowSelected(cell(forkTop, NodeColumn::node).row()));
  EXPECT_EQ(table().selectionModel()->selectedRows().size(), 1);
  EXPECT_EQ(table().currentIndex().row(), cell(forkTop, NodeColumn::node).row());
  action("select_all").trigger();
  EXPECT_EQ(table().selectionModel()->selectedRows().size(), 5);
  document().selection().clear();
  EXPECT_FALSE(table().selectionModel()->hasSelection());
}

TEST_F(NodeTableWindowTest, ShowsOnlyTheSelectedNodesOnRequest) {
  openTable();
  document().selection().set({forkRoot, forkTop});
  find<QCheckBox>("only_selected").click();
  EXPECT_EQ(table().model()->rowCount(), 2);
  clickRow(forkRoot);
  EXPECT_EQ(table().model()->rowCount(), 2) << "a click in the list does not shorten it";
  EXPECT_THAT(chosen(), ElementsAre(forkRoot));
  document().selection().set({forkTop});
  EXPECT_EQ(table().model()->rowCount(), 1);
  find<QCheckBox>("only_selected").click();
  EXPECT_EQ(table().model()->rowCount(), 5);
}

TEST_F(NodeTableWindowTest, FiltersAsOneTypes) {
  openTable();
  typeFilter("edge = +");
  EXPECT_EQ(table().model()->rowCount(), 2);
  EXPECT_EQ(count(), "2 of 5 nodes, 0 selected");
  const auto& wrong = find<QLabel>("node_filter_wrong");
  EXPECT_FALSE(wrong.isVisible());
  typeFilter("girth > 2");
  EXPECT_TRUE(wrong.isVisible());
  EXPECT_TRUE(wrong.text().startsWith("There is no column “girth”")) << wrong.text().toStdString();
  QCoreApplication::sendPostedEvents(); // of its place
  EXPECT_GE(wrong.width(), wrong.sizeHint().width()) << "nothing of it is cut";
  EXPECT_EQ(find<QWidget>("node_table_panel").visibleRegion().boundingRect().height(),
            find<QWidget>("node_table_panel").height())
      << "nor of the table";
  typeFilter("");
  EXPECT_FALSE(wrong.isVisible());
  EXPECT_EQ(table().model()->rowCount(), 5);
  EXPECT_TRUE(chosen().empty()) << "to filter selects nothing";
}

TEST_F(NodeTableWindowTest, SortsByAClickOnTheHeader) {
  openTable();
  QHeaderView* header = table().horizontalHeader();
  const int section = static_cast<int>(NodeColumn::z);
  const QPoint place(header->sectionViewportPosition(section) + 10, header->height() / 2);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, place);
  const auto first = table().model()->index(0, section).data().toDouble();
  const auto last = table().model()->index(4, section).data().toDouble();
  EXPECT_EQ(std::abs(first - last), 2);
}

TEST_F(NodeTableWindowTest, ARadiusIsTypedInPlaceAsOneStep) {
  openTable();
  auto* field = edit<QLineEdit>(forkTop, NodeColumn::radius);
  ASSERT_NE(field, nullptr);
  field->selectAll();
  QTest::keyClicks(field, "0.25");
  QTest::keyClick(field, Qt::Key_Return);
  QCoreApplication::processEvents(); // the table takes what was typed once the key is done
  EXPECT_EQ(document().skeleton()[forkTop].radius, 0.25);
  EXPECT_EQ(document().undoStack().count(), 1) << "and nothing is marked as reviewed";
  EXPECT_EQ(cell(forkTop, NodeColumn::radius).data(), "0.25000");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(document().skeleton()[forkTop].radius, 0.1, 1e-9);
}

TEST_F(NodeTableWindowTest, F2AndEnterChangeACell) {
  open({writeScan("scan.xyz")}); // of which one can be asked
  openTable();
  QSignalSpy asked(&action("ask_doubts"), &QAction::triggered);
  for (const Qt::Key key : {Qt::Key_F2, Qt::Key_Return}) {
    table().setFocus();
    table().setCurrentIndex(cell(forkTop, NodeColumn::radius));
    QTest::keyClick(&table(), key);
    auto* field = table().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    QTest::keyClick(field, Qt::Key_Escape);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    ASSERT_EQ(table().viewport()->findChild<QLineEdit*>(), nullptr);
  }
  EXPECT_TRUE(action("ask_doubts").isEnabled());
  EXPECT_EQ(asked.count(), 0);
}

TEST_F(NodeTableWindowTest, WhatIsNoRadiusIsReportedAndChangesNothing) {
  openTable();
  auto* field = edit<QLineEdit>(forkTop, NodeColumn::radius);
  ASSERT_NE(field, nullptr);
  field->selectAll();
  QTest::keyClicks(field, "thick");
  QTest::keyClick(field, Qt::Key_Return);
  QCoreApplication::processEvents(); // the table takes what was typed once the key is done
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(window().banner().text().contains("“thick” is no radius"));
}

TEST_F(NodeTableWindowTest, AnEdgeIsChosenInPlace) {
  openTable();
  const NodeId shoot = document().skeleton().children(forkTop).front(); // the successor
  auto* types = edit<QComboBox>(shoot, NodeColumn::edge);
  ASSERT_NE(types, nullptr);
  QTest::keyClick(types, Qt::Key_Down);
  table().setFocus(); // leaves the cell
  EXPECT_EQ(document().skeleton()[shoot].edge, EdgeType::branching);
  EXPECT_EQ(document().undoStack().count(), 1);
}

TEST_F(NodeTableWindowTest, FollowsEdits) {
  openTable();
  document().edit("Add", [](SkeletonEditor& editor) {
    editor.add({.position = {0, 0, 3}, .parent = forkTop});
  });
  EXPECT_TRUE(QTest::qWaitFor([this] { return table().model()->rowCount() == 6; }, patience));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(QTest::qWaitFor([this] { return table().model()->rowCount() == 5; }, patience));
  open({writeFork("other.mtg")});
  EXPECT_EQ(table().model()->rowCount(), 5);
}

TEST_F(NodeTableWindowTest, CopiesTheSelectedRowsOrAll) {
  openTable();
  clickRow(forkTop);
  key(Qt::Key_C, Qt::ControlModifier);
  QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), 2);
  EXPECT_TRUE(lines[0].startsWith("node\tparent\t")) << lines[0].toStdString();
  EXPECT_TRUE(lines[0].contains("radius [m]"));
  EXPECT_TRUE(lines[1].startsWith(QString::number(indexOf(forkTop)) + "\t"));
  EXPECT_EQ(window().statusLine().shownText(), "Copied 1 row");
  document().selection().clear();
  clickButton("copy_table");
  lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
  EXPECT_EQ(lines.size(), 6);
}

TEST_F(NodeTableWindowTest, CopyTakesTheSelectedNodesWithoutATable) {
  open({writeFork("fork.mtg")});
  QApplication::clipboard()->setText("as before");
  action("copy").trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), "as before");
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Select the nodes to copy"));
  document().selection().set({forkTop, forkRoot});
  action("copy").trigger();
  EXPECT_EQ(QApplication::clipboard()->text().count('\n'), 3);
}

TEST_F(NodeTableWindowTest, KeysChooseTheOnlyRowAndTheFirstAndTheLast) {
  openTable();
  document().selection().set({forkRoot});
  typeFilter("node = 1");
  auto& table = find<QTableView>("node_table");
  ASSERT_EQ(table.model()->rowCount(), 1);
  table.setFocus(Qt::TabFocusReason);
  EXPECT_EQ(chosen(), std::vector{forkRoot});
  QTest::keyClick(&table, Qt::Key_Down);
  EXPECT_EQ(chosen(), std::vector{NodeId{1}});
  typeFilter("");
  const int rows = table.model()->rowCount();
  QTest::keyClick(&table, Qt::Key_End);
  EXPECT_EQ(table.currentIndex().row(), rows - 1);
  QTest::keyClick(&table, Qt::Key_Home);
  EXPECT_EQ(table.currentIndex().row(), 0);
  EXPECT_EQ(chosen().size(), 1U);
}

TEST_F(NodeTableWindowTest, CtrlCInTheFilterCopiesItsText) {
  openTable();
  typeFilter("order = 1");
  auto& field = find<QLineEdit>("node_filter");
  field.selectAll();
  QTest::keyClick(&field, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), "order = 1");
}

} // namespace
} // namespace espalier
