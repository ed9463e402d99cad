// What keys, menus and the wheel do to nodes, in the real window.
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/status_line.h"
#include "ui/tools/node_choices.h"
#include "ui/tools/node_edits.h"

#include <QAction>
#include <QInputDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QWheelEvent>

namespace espalier {
namespace {

using test::forkTop;

struct NodeKeysTest : test::WindowTest {
  void SetUp() override { open({writeFork("fork.mtg")}); }

  std::size_t selected() { return document().selection().nodes().size(); }
  void wheel(int notches) {
    const QPointF place = view().rect().center();
    QWheelEvent event(place, view().mapToGlobal(place), {}, QPoint(0, 120 * notches), Qt::NoButton,
                      Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view(), &event);
  }
};

TEST_F(NodeKeysTest, DigitsSelectFromTheNodeUnderThePointer) {
  hover(placeOf(nodeAt({0, 0, 1})));
  key(Qt::Key_1);
  EXPECT_EQ(selected(), 4U) << "the top and its three shoots";
  hover({5, 5});
  key(Qt::Key_6);
  EXPECT_EQ(selected(), 1U);
  key(Qt::Key_Plus);
  EXPECT_EQ(selected(), 2U);
  key(Qt::Key_Minus);
  EXPECT_EQ(selected(), 1U);
  EXPECT_EQ(document().undoStack().count(), 0) << "nothing was edited";
}

TEST_F(NodeKeysTest, DigitsOfTheKeypadTurnTheView) {
  const auto before = view().camera();
  key(Qt::Key_8, Qt::KeypadModifier);
  waitForView();
  EXPECT_FALSE(view().camera().forward().isApprox(before.forward()));
  EXPECT_GT(std::abs(view().camera().forward().z()), 0.99) << "from the top";
  hover(placeOf(nodeAt({1, 0, 2})));
  key(Qt::Key_5, Qt::KeypadModifier);
  EXPECT_EQ(selected(), 0U);
}

/// The edge from the foot to the top is all that the pointer is on, and nothing is selected.
TEST_F(NodeKeysTest, NeedANodeWhereThePointerIsOnAnEdge) {
  const QPoint middle = view().project({0, 0, 0.5})->toPoint();
  ASSERT_TRUE(view().pick(middle).edge);
  ASSERT_FALSE(view().pick(middle).node);
  const Skeleton before = document().skeleton();
  const auto expectRefused = [&](const QString& id) {
    document().selection().clear();
    hover({5, 5});
    hover(middle);
    find<StatusLine>("status_line").showNote("none");
    action(id).trigger();
    EXPECT_EQ(document().skeleton(), before) << id.toStdString();
    EXPECT_EQ(window().statusLine().shownText(), "Put the pointer on a node, or select one")
        << id.toStdString();
  };
  for (const NodeEdit& edit : nodeEdits())
    if (!edit.takesEdge && !edit.isOfSelected) expectRefused(edit.id);
  for (const NodeChoice& choice : nodeChoices())
    if (!choice.id.isEmpty() && choice.needsNodes) expectRefused(choice.id);
  expectRefused("resample");

  document().selection().clear();
  hover(middle);
  key(Qt::Key_E);
  EXPECT_EQ(document().skeleton().size(), before.size() + 1) << "an edge is split all the same";
  action("undo").trigger();
  document().selection().clear();
  hover({5, 5});
  hover(middle);
  key(Qt::Key_X);
  EXPECT_EQ(document().skeleton().roots().size(), 2U) << "and cut";
}

TEST_F(NodeKeysTest, CutAndJoinBringTheBranchBack) {
  const Skeleton start = document().skeleton();
  const NodeId apex = nodeAt({1, 0, 2});
  hover(placeOf(apex));
  key(Qt::Key_X);
  EXPECT_EQ(document().skeleton().roots().size(), 2U);
  key(Qt::Key_J);
  EXPECT_EQ(document().skeleton().roots().size(), 1U);
  EXPECT_EQ(document().skeleton()[apex].parent, start[apex].parent);
}

TEST_F(NodeKeysTest, SpaceGoesOnFromTheNewChildWhereverThePointerIs) {
  hover(placeOf(nodeAt({1, 0, 2})));
  key(Qt::Key_N);
  const NodeId first = document().selection().current().value();
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_Space);
  const NodeId second = document().selection().current().value();
  EXPECT_EQ(document().skeleton()[second].parent, first);
  EXPECT_EQ(document().skeleton().size(), 7U);
}

TEST_F(NodeKeysTest, CtrlWheelThickensTheSelectedNodesAsOneStep) {
  document().selection().set({forkTop, NodeId{3}});
  hover({5, 5});
  wheel(1);
  wheel(1);
  EXPECT_NEAR(document().skeleton()[forkTop].radius, 0.1 * 1.05 * 1.05, 1e-6);
  EXPECT_NEAR(document().skeleton()[NodeId{3}].radius, 0.1 * 1.05 * 1.05, 1e-6);
  EXPECT_EQ(document().undoStack().count(), 1);
  document().selection().set({forkTop});
  wheel(-1);
  EXPECT_EQ(document().undoStack().count(), 2) << "of other nodes";
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(document().skeleton()[forkTop].radius, 0.1, 1e-6);
}

TEST_F(NodeKeysTest, CtrlWheelZoomsWhereNoNodeIsMeant) {
  const auto before = view().camera();
  hover({5, 5});
  wheel(2);
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_FALSE(view().camera() == before);
}

TEST_F(NodeKeysTest, AnEditThatChangesNothingIsAnswered) {
  document().selection().set({nodeAt({0, 0, 0}), nodeAt({0, 0, 1})});
  action("space_evenly").trigger();
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(window().statusLine().shownText().contains("Space Evenly: nothing to change here"))
      << window().statusLine().shownText().toStdString();
}

TEST_F(NodeKeysTest, ResampleAsksForALength) {
  document().selection().set({nodeAt({0, 0, 0}), nodeAt({0, 0, 1})});
  answer(
      [](QDialog& dialog) {
        auto& input = dynamic_cast<QInputDialog&>(dialog);
        EXPECT_NEAR(input.doubleValue(), 1, 1e-3) << "as it is";
        input.setDoubleValue(0.25);
        input.accept();
      },
      [this] { action("resample").trigger(); });
  EXPECT_EQ(document().skeleton().size(), 8U);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton().size(), 5U);
}

TEST_F(NodeKeysTest, MenusHoldAllEditsOfNodes) {
  QStringList menus;
  for (const QAction* menu : window().menuBar()->actions())
    menus.append(menu->text().remove('&'));
  EXPECT_TRUE(menus.contains("Select"));
  for (const char* id : {"cut_off", "turn_around", "resample", "select_axis", "merge"}) {
    int places = 0;
    for (const QObject* owner : action(id).associatedObjects())
      if (qobject_cast<const QMenu*>(owner) != nullptr) ++places;
    EXPECT_GE(places, 1) << id;
  }
}

TEST_F(NodeKeysTest, ARefusedEditSaysWhyAndChangesNothing) {
  const Skeleton start = document().skeleton();
  hover(placeOf(nodeAt({0, 0, 0})));
  key(Qt::Key_X);
  EXPECT_EQ(document().skeleton(), start);
  EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(NodeKeysTest, ArrowsStepFromNodeToNodeAndEditsFollow) {
  view().setFocus();
  const auto at = [this] { return document().selection().nodes(); };
  key(Qt::Key_Up);
  EXPECT_EQ(at(), std::vector{nodeAt({0, 0, 0})}) << "from none to the root";
  key(Qt::Key_Up);
  key(Qt::Key_Up);
  const NodeId first = at().front();
  key(Qt::Key_Right);
  EXPECT_NE(at().front(), first);
  EXPECT_EQ(document().skeleton()[at().front()].parent, document().skeleton()[first].parent);
  key(Qt::Key_Left);
  EXPECT_EQ(at(), std::vector{first});
  key(Qt::Key_Down);
  EXPECT_EQ(at(), std::vector{nodeAt({0, 0, 1})});
  EXPECT_EQ(document().undoStack().count(), 0) << "nothing was edited";
  hover(placeOf(nodeAt({0, 0, 0})));
  key(Qt::Key_Up); // from what is selected, not from the pointer
  EXPECT_EQ(at(), std::vector{first});
  key(Qt::Key_Delete);
  EXPECT_FALSE(document().skeleton().contains(first)) << "not the node under the pointer";
  EXPECT_TRUE(document().skeleton().contains(nodeAt({0, 0, 0})));
}

TEST_F(NodeKeysTest, BelongToAMenuThatIsOpen) {
  const auto isKeptFromShortcuts = [this](Qt::Key key) {
    QKeyEvent asked(QEvent::ShortcutOverride, key, Qt::NoModifier);
    asked.ignore();
    QApplication::sendEvent(&view(), &asked);
    return asked.isAccepted();
  };
  QMenu menu(&window());
  menu.addAction("One");
  for (const Qt::Key key : {Qt::Key_Right, Qt::Key_N, Qt::Key_Delete}) {
    EXPECT_FALSE(isKeptFromShortcuts(key)) << key;
    menu.popup(window().mapToGlobal(QPoint(40, 40)));
    EXPECT_TRUE(isKeptFromShortcuts(key)) << key;
    menu.close();
  }
  EXPECT_FALSE(isKeptFromShortcuts(Qt::Key_Right)) << "they are those of the view again";
}

TEST_F(NodeKeysTest, ArrowsEndWithAWordAndTheViewFollows) {
  view().setFocus();
  key(Qt::Key_Up);
  key(Qt::Key_Down);
  EXPECT_EQ(document().selection().nodes(), std::vector{nodeAt({0, 0, 0})}) << "a root stays";
  Camera away = view().camera();
  away.focus = away.pivot = {50, 0, 0};
  view().setCamera(away);
  key(Qt::Key_Up);
  waitForView();
  const std::optional<QPointF> place =
      view().project(document().skeleton()[document().selection().nodes().front()].position);
  ASSERT_TRUE(place);
  EXPECT_TRUE(QRectF(view().rect()).contains(*place));
}

} // namespace
} // namespace espalier
