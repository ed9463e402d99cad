// Trace, Stroke and Regrow by mouse and keys in the real window.
#include "app/window/edit/editing.h"
#include "app/window/files/load_files.h"
#include "core/io/formats.h"
#include "core/skeleton/edits.h"
#include "tests/app/window/window_fixture.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QTest>

#include <algorithm>

namespace espalier {
namespace {

/// Over the scan of a trunk of 2 m with three branches, of which the skeleton has none but the
/// trunk, with a node each 0.25 m.
class TraceWindowTest : public test::WindowTest {
protected:
  TraceWindowTest() {
    Skeleton trunk;
    std::optional<NodeId> last;
    for (int i = 0; i <= 8; ++i)
      last = trunk.add({.position = {0, 0, 0.25 * i}, .radius = 0.05, .parent = last});
    writeStructure(toPath(path("trunk.mtg")), trunk);
    open({writeScan("scan.xyz"), path("trunk.mtg")});
    before_ = document().skeleton();
    action("view_front").trigger();
    waitForView();
  }

  /// Where a place of the plant is seen.
  QPoint at(const Eigen::Vector3d& place) { return view().project(place)->toPoint(); }
  QPoint atNode(double height) { return at({0, 0, height}); }
  bool waitForPreview() {
    return QTest::qWaitFor([this] { return action("accept").isEnabled(); }, patience);
  }
  void stroke(const std::vector<QPoint>& places) {
    hover(places.front());
    QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, places.front());
    for (std::size_t i = 1; i < places.size(); ++i)
      for (int step = 1; step <= 8; ++step)
        moveTo(places[i - 1] + (places[i] - places[i - 1]) * step / 8);
  }
  void release(const QPoint& place) {
    QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, place);
  }
  void expectUndone() {
    action("undo").trigger();
    EXPECT_EQ(document().skeleton(), before_);
    EXPECT_FALSE(document().undoStack().canUndo());
  }

  Skeleton before_;

private:
  void moveTo(const QPoint& place) {
    QMouseEvent move(QEvent::MouseMove, QPointF(place), QPointF(view().mapToGlobal(place)),
                     Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view(), &move);
  }
};

/// How far the farthest of the new nodes is from the branch that leads along +x.
double farthestOff(const Skeleton& skeleton, const Skeleton& before) {
  const Eigen::Vector3d foot(0, 0, 1);
  const Eigen::Vector3d along = Eigen::Vector3d(0.8, 0, 0.6).normalized();
  double farthest = 0;
  for (const NodeId id : skeleton.ids()) {
    if (before.contains(id)) continue;
    const Eigen::Vector3d off = skeleton[id].position - foot;
    farthest = std::max(farthest, (off - off.dot(along) * along).norm());
  }
  return farthest;
}

TEST_F(TraceWindowTest, TracesABranchBetweenTwoClicks) {
  key(Qt::Key_L);
  click(atNode(1));
  const QPoint tip = at({0.76, 0, 1.57});
  hover(at({0.4, 0, 1.3}));
  ASSERT_TRUE(waitForPreview());
  EXPECT_EQ(document().skeleton(), before_) << "changed before it was accepted";
  click(tip);
  ASSERT_TRUE(waitForPreview());
  key(Qt::Key_Return);
  const Skeleton& plant = document().skeleton();
  ASSERT_GT(plant.size(), before_.size());
  EXPECT_EQ(plant.roots().size(), 1U);
  EXPECT_LT(farthestOff(plant, before_), 0.05);
  expectUndone();
}

TEST_F(TraceWindowTest, DropsATraceOnEscape) {
  key(Qt::Key_L);
  click(atNode(1));
  hover(at({0.4, 0, 1.3}));
  ASSERT_TRUE(waitForPreview());
  key(Qt::Key_Escape);
  EXPECT_FALSE(action("accept").isEnabled());
  EXPECT_EQ(document().skeleton(), before_);
  EXPECT_FALSE(document().undoStack().canUndo());
}

TEST_F(TraceWindowTest, CutsWithAStroke) {
  key(Qt::Key_Y);
  const QPoint from = at({-0.3, 0, 0.62});
  const QPoint to = at({0.3, 0, 0.62});
  stroke({from, to});
  EXPECT_EQ(document().skeleton(), before_);
  release(to);
  EXPECT_EQ(document().skeleton().roots().size(), 2U);
  expectUndone();
}

TEST_F(TraceWindowTest, LeavesAStrokeOnEscape) {
  key(Qt::Key_Y);
  const QPoint to = at({0.3, 0, 0.62});
  stroke({at({-0.3, 0, 0.62}), to});
  key(Qt::Key_Escape);
  release(to);
  EXPECT_EQ(document().skeleton(), before_);
  EXPECT_FALSE(document().undoStack().canUndo());
}

TEST_F(TraceWindowTest, DrawsABranchAlongThePoints) {
  key(Qt::Key_Y);
  const QPoint tip = at({0.76, 0, 1.57});
  stroke({atNode(1), at({0.4, 0, 1.3}), tip});
  release(tip);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().skeleton() != before_; }, patience));
  EXPECT_EQ(document().skeleton().roots().size(), 1U);
  EXPECT_LT(farthestOff(document().skeleton(), before_), 0.05);
  expectUndone();
}

TEST_F(TraceWindowTest, RegrowsWhatANodeCarries) {
  hover(atNode(0.75));
  key(Qt::Key_N, Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  EXPECT_EQ(document().skeleton(), before_) << "changed before it was accepted";
  key(Qt::Key_Return);
  const Skeleton& plant = document().skeleton();
  const auto ids = plant.ids();
  EXPECT_GE(std::ranges::count_if(ids, [&](NodeId id) { return plant.children(id).empty(); }), 4)
      << "the trunk and its three branches";
  for (const NodeId id : before_.ids())
    if (before_[id].position.z() < 0.8) {
      EXPECT_EQ(plant[id], before_[id]);
    }
  expectUndone();
}

TEST_F(TraceWindowTest, ProposesNothingForAPlantThatWasEditedMeanwhile) {
  hover(atNode(0.75));
  key(Qt::Key_N, Qt::ShiftModifier);
  ASSERT_TRUE(window().jobs().isBusy());
  document().edit("Cut", [&](SkeletonEditor& editor) {
    for (const NodeId id : before_.ids())
      if (before_[id].position.z() > 0.6 && editor.skeleton().contains(id))
        removeSubtree(editor, id);
  });
  const Skeleton cut = document().skeleton();
  waitForJob();
  EXPECT_TRUE(window().statusLine().shownText().startsWith("The plant was edited meanwhile"));
  EXPECT_FALSE(action("accept").isEnabled());
  EXPECT_EQ(document().skeleton(), cut);
}

TEST_F(TraceWindowTest, SaysThatTheNodeIsGoneWhichWasToCarryWhatIsProposed) {
  hover(atNode(0.75));
  key(Qt::Key_N, Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  document().edit("Cut", [&](SkeletonEditor& editor) {
    removeSubtree(editor, nodeAt({0, 0, 0.75}));
  });
  const Skeleton cut = document().skeleton();
  key(Qt::Key_Return);
  EXPECT_EQ(window().statusLine().shownText(), "The node is gone: choose another one");
  EXPECT_EQ(document().skeleton(), cut);
}

TEST_F(TraceWindowTest, RegrowsFromAnotherNodeThatIsClickedInstead) {
  hover(atNode(0.75));
  key(Qt::Key_N, Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  click(atNode(0.5));
  waitForJob();
  ASSERT_TRUE(waitForPreview()) << "the proposal can be accepted";
  EXPECT_TRUE(action("tool_regrow").isChecked());
  key(Qt::Key_Escape);
  EXPECT_FALSE(action("accept").isEnabled()) << "and dropped";
  EXPECT_EQ(document().skeleton(), before_);
}

TEST_F(TraceWindowTest, RegrowsAllBranchesThatAreMissing) {
  key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  EXPECT_EQ(document().skeleton(), before_) << "changed before it was accepted";
  key(Qt::Key_Return);
  const Skeleton& plant = document().skeleton();
  EXPECT_EQ(plant.roots().size(), 1U);
  for (const Eigen::Vector3d& tip :
       {Eigen::Vector3d(0.8, 0, 1.6), {-0.7, 0.1, 1.9}, {0.1, 0.7, 1.3}}) {
    double nearest = 1;
    for (const NodeId id : plant.ids())
      nearest = std::min(nearest, (plant[id].position - tip).norm());
    EXPECT_LT(nearest, 0.1) << tip.transpose();
  }
  for (const NodeId id : before_.ids()) { // what was there stays, but for new nodes on its edges
    EXPECT_EQ(plant[id].position, before_[id].position);
    EXPECT_EQ(plant[id].radius, before_[id].radius);
    std::optional<NodeId> parent = plant[id].parent;
    while (parent && !before_.contains(*parent))
      parent = plant[*parent].parent;
    EXPECT_EQ(parent, before_[id].parent);
  }
  EXPECT_TRUE(action("tool_move").isChecked()) << "back to the tool before";
  expectUndone();
}

TEST_F(TraceWindowTest, PagesThroughTheMissingBranchesByTheirLength) {
  EXPECT_FALSE(action("fewer_branches").isEnabled());
  key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  const auto shown = [&] { return window().statusLine().shownText().section(' ', 0, 0).toInt(); };
  const int all = shown();
  ASSERT_GT(all, 1) << window().statusLine().shownText().toStdString();
  key(Qt::Key_PageUp);
  EXPECT_EQ(shown(), all - 1);
  EXPECT_TRUE(action("more_branches").isEnabled());
  key(Qt::Key_PageDown);
  EXPECT_EQ(shown(), all);
  key(Qt::Key_Escape);
  EXPECT_FALSE(action("fewer_branches").isEnabled());
  EXPECT_EQ(document().skeleton(), before_);
}

TEST_F(TraceWindowTest, WalksTheMissingBranchesByKeys) {
  const auto shown = [&] { return window().statusLine().shownText().section(' ', 0, 0).toInt(); };
  const Camera before = view().camera();
  EXPECT_FALSE(action("take_branch").isEnabled());
  key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  const int all = shown();
  ASSERT_GT(all, 1);
  ASSERT_TRUE(action("take_branch").isEnabled());
  EXPECT_NE(view().camera(), before) << "the first is shown";
  key(Qt::Key_Return, Qt::ShiftModifier);
  for (int i = 1; i < all; ++i) {
    EXPECT_EQ(document().skeleton(), before_) << "changed before all are chosen";
    key(Qt::Key_Backspace, Qt::ShiftModifier);
  }
  EXPECT_FALSE(action("take_branch").isEnabled());
  const Skeleton& plant = document().skeleton();
  EXPECT_GT(plant.size(), before_.size());
  const auto ids = plant.ids();
  EXPECT_EQ(std::ranges::count_if(ids, [&](NodeId id) { return plant.children(id).empty(); }), 2)
      << "the trunk, and the branch that was taken";
  EXPECT_TRUE(action("tool_move").isChecked());
  expectUndone();
}

TEST_F(TraceWindowTest, LeavesTheWalkOfMissingBranchesOnEscape) {
  key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  key(Qt::Key_Return, Qt::ShiftModifier);
  key(Qt::Key_Escape);
  EXPECT_EQ(document().skeleton(), before_);
  EXPECT_FALSE(document().undoStack().canUndo());
  EXPECT_FALSE(action("drop_branch").isEnabled());
}

TEST_F(TraceWindowTest, BeginsATraceWhereItsPointsLeaveTheTrunk) {
  key(Qt::Key_L);
  click(atNode(0.5));
  click(at({0.76, 0, 1.57}));
  ASSERT_TRUE(waitForPreview());
  key(Qt::Key_Return);
  const Skeleton& plant = document().skeleton();
  const auto ids = plant.ids();
  const auto branch = std::ranges::find_if(
      ids, [&](NodeId id) { return plant[id].parent && plant[id].edge == EdgeType::branching; });
  ASSERT_NE(branch, ids.end());
  EXPECT_NEAR(plant[*plant[*branch].parent].position.z(), 1, 0.1) << "and not at the click";
  expectUndone();
}

TEST_F(TraceWindowTest, DropsTheMissingBranchesOnEscape) {
  action("regrow_missing").trigger();
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  key(Qt::Key_Escape);
  EXPECT_FALSE(action("accept").isEnabled());
  EXPECT_EQ(document().skeleton(), before_);
  EXPECT_FALSE(document().undoStack().canUndo());
}

TEST_F(TraceWindowTest, DropsWhatGrewOnEscape) {
  hover(atNode(0.75));
  key(Qt::Key_N, Qt::ShiftModifier);
  waitForJob();
  ASSERT_TRUE(waitForPreview());
  key(Qt::Key_Escape);
  EXPECT_FALSE(action("accept").isEnabled());
  EXPECT_EQ(document().skeleton(), before_);
}

TEST_F(TraceWindowTest, OffersTabOnlyWhereThereIsAnotherPath) {
  EXPECT_FALSE(action("next_way").isEnabled());
  key(Qt::Key_L);
  click(atNode(1));
  hover(at({0.4, 0, 1.3}));
  ASSERT_TRUE(waitForPreview());
  EXPECT_FALSE(action("next_way").isEnabled()) << "one path is shown while the pointer moves";
}

} // namespace
} // namespace espalier
