#include "app/window/frame/panel_keys.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QEnterEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include <numbers>
#include <set>
#include <stdexcept>

namespace espalier {
namespace {

struct PanelKeysTest : test::WindowTest {
  void openFork() { open({writeScan("scan.xyz"), writeFork("fork.mtg")}); }
  static void press(QWidget& widget, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&widget, static_cast<Qt::Key>(key), modifiers);
  }
  QToolButton& buttonOf(const QString& id) {
    for (QToolButton* button : window().findChildren<QToolButton*>())
      if (button->defaultAction() == &action(id) && dockOf(button) != nullptr) return *button;
    throw std::runtime_error("no panel has a button for " + id.toStdString());
  }
};

TEST_F(PanelKeysTest, EnterPressesTheButtonThatTabLedTo) {
  openFork();
  key(Qt::Key_F9);
  document().selection().set({test::forkTop});
  QToolButton& doubtful = buttonOf("mark_doubtful");
  doubtful.setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(doubtful.hasFocus());
  press(doubtful, Qt::Key_Return);
  EXPECT_EQ(document().skeleton()[test::forkTop].review.state, ReviewState::doubtful);
}

TEST_F(PanelKeysTest, EnterAfterAClickOnAButtonIsThatOfTheView) {
  openFork();
  key(Qt::Key_F9);
  auto& reconstruct = find<QPushButton>("reconstruct_button");
  const QSignalSpy pressed(&reconstruct, &QPushButton::clicked);
  document().selection().set({test::forkTop});
  reconstruct.setFocus(Qt::MouseFocusReason);
  ASSERT_TRUE(reconstruct.hasFocus());
  press(reconstruct, Qt::Key_Return);
  EXPECT_EQ(pressed.count(), 0);
  reconstruct.clearFocus();
  reconstruct.setFocus(Qt::TabFocusReason);
  press(reconstruct, Qt::Key_Return);
  EXPECT_EQ(pressed.count(), 1);
}

TEST_F(PanelKeysTest, TabLeadsToNothingThatOneDoesNotSee) {
  openFork();
  for (const int panel : {Qt::Key_F9, Qt::Key_F8})
    key(panel); // behind each other's tabs
  QTest::qWait(50);
  std::set<const QDockWidget*> docks;
  for (int i = 0; i < 120; ++i) {
    const QWidget* before = QApplication::focusWidget();
    press(*QApplication::focusWidget(), Qt::Key_Tab);
    ASSERT_NE(QApplication::focusWidget(), before);
    QDockWidget* dock = dockOf(QApplication::focusWidget());
    if (dock == nullptr) continue;
    EXPECT_TRUE(isInFront(*dock)) << dock->windowTitle().toStdString();
    docks.insert(dock);
  }
  EXPECT_GT(docks.size(), 1U);
  QWidget* there = QApplication::focusWidget();
  press(*there, Qt::Key_Tab);
  press(*QApplication::focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_EQ(QApplication::focusWidget(), there);
}

TEST_F(PanelKeysTest, UndoPassesByAFieldInWhichNothingWasTyped) {
  openFork();
  edit();
  document().selection().set({test::forkTop});
  const int steps = document().undoStack().index();
  auto& radius = find<QDoubleSpinBox>("node_radius");
  radius.setFocus(Qt::TabFocusReason);
  QTest::keyClicks(&radius, "7");
  press(radius, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().index(), steps) << "what was typed is taken back";
  press(radius, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().index(), steps - 1);
}

TEST_F(PanelKeysTest, TheListOfAxesChoosesNoneAsTheKeyboardComes) {
  openFork();
  key(Qt::Key_F9);
  document().selection().set({test::forkTop});
  auto& axes = find<QTableView>("review_axes");
  ASSERT_TRUE(QTest::qWaitFor([&] { return axes.model()->rowCount() > 1; }, patience));
  axes.setFocus(Qt::TabFocusReason);
  EXPECT_EQ(document().selection().nodes(), std::vector{test::forkTop});
  press(axes, Qt::Key_Down);
  EXPECT_NE(document().selection().nodes(), std::vector{test::forkTop});
}

TEST_F(PanelKeysTest, NoRowIsCurrentUntilAKeyChoosesOne) {
  openFork();
  key(Qt::Key_F9);
  auto& axes = find<QTableView>("review_axes");
  ASSERT_TRUE(QTest::qWaitFor([&] { return axes.model()->rowCount() > 1; }, patience));
  axes.setFocus(Qt::TabFocusReason);
  EXPECT_FALSE(axes.currentIndex().isValid());
  press(axes, Qt::Key_Down);
  EXPECT_EQ(axes.currentIndex().row(), 0);
}

// Of which the node chosen last is not listed.
TEST_F(PanelKeysTest, TheTableOfNodesKeepsTheSelectionAsTheKeyboardComes) {
  openFork();
  key(Qt::Key_F11);
  document().selection().set({test::forkRoot, test::forkTop});
  auto& table = find<QTableView>("node_table");
  auto* model = table.selectionModel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return model->selectedRows().size() == 2; }, patience));
  table.setSelectionMode(QAbstractItemView::NoSelection);
  table.setCurrentIndex({});
  table.setSelectionMode(QAbstractItemView::ExtendedSelection);
  ASSERT_EQ(model->selectedRows().size(), 2);
  table.clearFocus();
  table.setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(table.hasFocus());
  EXPECT_EQ(document().selection().nodes().size(), 2U);
}

TEST_F(PanelKeysTest, EnterInAListAcceptsThePreview) {
  openFork();
  key(Qt::Key_F9);
  auto& axes = find<QTableView>("review_axes");
  ASSERT_TRUE(QTest::qWaitFor([&] { return axes.model()->rowCount() > 1; }, patience));
  const NodeId branch = document().skeleton().children(test::forkTop).back();
  document().selection().set({branch});
  key(Qt::Key_P);
  key(Qt::Key_Down);
  key(Qt::Key_Down); // what bears what bears it
  ASSERT_TRUE(action("accept").isEnabled());
  const NodeId root = document().skeleton().roots().front();
  axes.setFocus(Qt::TabFocusReason);
  press(axes, Qt::Key_Return);
  EXPECT_EQ(document().skeleton()[branch].parent, root);
}

TEST_F(PanelKeysTest, LettersChooseInAListOfChoicesThatTabLedTo) {
  openFork();
  document().selection().set({test::forkTop});
  auto& up = find<QComboBox>("up"); // x, y, z
  const std::size_t before = document().skeleton().size();
  up.setCurrentIndex(2);
  up.setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(up.hasFocus());
  press(up, Qt::Key_Y);
  EXPECT_EQ(up.currentText(), "y");
  press(up, Qt::Key_N);
  EXPECT_EQ(document().skeleton().size(), before) << "nothing is done to the plant";
  up.clearFocus();
  up.setFocus(Qt::MouseFocusReason);
  up.showPopup();
  up.hidePopup();
  up.setFocus(Qt::PopupFocusReason);
  press(up, Qt::Key_N);
  EXPECT_EQ(document().skeleton().size(), before + 1) << "after a click keys are the plant's";
}

// As where a list of choices closes that was opened by the keyboard.
TEST_F(PanelKeysTest, ThePointerTakesTheKeyboardOnlyAsItMoves) {
  openFork();
  const auto enter = [this](const QPointF& place) {
    QEnterEvent event(place, view().mapTo(&window(), place), view().mapToGlobal(place));
    QApplication::sendEvent(&view(), &event);
  };
  enter({50, 50});
  auto& reconstruct = find<QPushButton>("reconstruct_button");
  reconstruct.setFocus(Qt::TabFocusReason);
  enter({50, 50});
  EXPECT_TRUE(reconstruct.hasFocus());
  enter({51, 50});
  EXPECT_TRUE(view().hasFocus());
}

TEST_F(PanelKeysTest, TheViewIsTurnedMovedAndZoomedStepByStep) {
  openFork();
  waitForView();
  const Camera before = view().camera();
  key(Qt::Key_Left, Qt::AltModifier);
  key(Qt::Key_Left, Qt::AltModifier); // while the view still flies
  EXPECT_NEAR(view().camera().yaw - before.yaw, std::numbers::pi / 6, 1e-9);
  key(Qt::Key_Down, Qt::AltModifier);
  EXPECT_GT(view().camera().pitch, before.pitch);
  key(Qt::Key_Up, Qt::AltModifier);
  key(Qt::Key_Right, Qt::AltModifier);
  key(Qt::Key_Right, Qt::AltModifier);
  EXPECT_NEAR(view().camera().yaw, before.yaw, 1e-9);
  key(Qt::Key_Right, Qt::AltModifier | Qt::ShiftModifier);
  const Eigen::Vector3d moved = view().camera().focus - before.focus;
  EXPECT_NEAR(moved.dot(before.right()), -0.2 * before.halfHeight(), 1e-6);
  key(Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_NEAR(view().camera().distance, before.distance / 1.25, 1e-9);
  key(Qt::Key_Minus, Qt::ControlModifier);
  EXPECT_NEAR(view().camera().distance, before.distance, 1e-9);
}

TEST_F(PanelKeysTest, UndoSelectsWhereWhatIsNoLongerThereWas) {
  openFork();
  const NodeId top = test::forkTop;
  document().selection().set({top});
  key(Qt::Key_N);
  const std::vector<NodeId> added = document().selection().nodes();
  ASSERT_NE(added, std::vector{top});
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().selection().nodes(), std::vector{top});
  key(Qt::Key_Delete, Qt::ShiftModifier);
  ASSERT_FALSE(document().skeleton().contains(top));
  EXPECT_TRUE(document().selection().isEmpty());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().selection().nodes(), std::vector{top});
}

} // namespace
} // namespace espalier
