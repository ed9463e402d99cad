// What a review marks: only what is seen, never much at once, and no doubt in passing.
#include "tests/app/window/review_fixture.h"
#include "ui/panels/coverage_bar.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/review_panel.h"
#include "ui/panels/status_line.h"
#include "ui/panels/step_form.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include <algorithm>

namespace espalier {
namespace {

using test::ReviewWindowTest;

TEST_F(ReviewWindowTest, EnterShowsFirstWhatIsNotSeenAndMarksItTheNextTime) {
  openFork();
  key(Qt::Key_F9);
  const auto expectShownFirst = [&](const std::vector<NodeId>& nodes, const QString& why) {
    document().selection().set(nodes);
    key(Qt::Key_Return);
    for (const NodeId id : nodes)
      EXPECT_EQ(markOf(id).state, ReviewState::toDo) << why.toStdString();
    EXPECT_TRUE(window().statusLine().shownText().startsWith(
        "Nothing is marked yet, as " + why + ": now it is shown, and Enter marks it"))
        << window().statusLine().shownText().toStdString();
    waitForView();
    for (const NodeId id : nodes)
      EXPECT_TRUE(isDrawn(id)) << why.toStdString();
    EXPECT_EQ(chosen(), nodes);
    key(Qt::Key_Return);
    for (const NodeId id : nodes)
      EXPECT_EQ(markOf(id).state, ReviewState::reviewed) << why.toStdString();
    key(Qt::Key_Z, Qt::ControlModifier);
  };
  const QString name = QString("node %1").arg(indexOf(shoot()));
  const std::vector<NodeId> trunk{nodeAt({0, 0, 0}), nodeAt({0, 0, 1})};
  const Eigen::Vector3d low(-2, -2, -1);
  const Eigen::Vector3d high(2, 2, 3);
  view().setClip({.slab = {}, .box = Eigen::AlignedBox3d(low, Eigen::Vector3d(2, 2, 1.9))});
  expectShownFirst({shoot()}, name + " was clipped away");
  view().setClip({.slab = {}, .box = Eigen::AlignedBox3d(Eigen::Vector3d(-2, -2, 1.5), high)});
  expectShownFirst({shoot()}, name + " was clipped away"); // the foot of its edge
  view().setClip({.slab = {}, .box = Eigen::AlignedBox3d(Eigen::Vector3d(-2, -2, 0.5), high)});
  expectShownFirst(trunk, "2 of the 2 nodes selected were clipped away");
  view().setClip({});
  Camera aside = view().camera();
  aside.focus += 100 * aside.right();
  view().setCamera(aside);
  expectShownFirst({shoot()}, name + " was outside the view");
  document().selection().set({trunk.back()});
  action("hide").trigger();
  expectShownFirst(trunk, "1 of the 2 nodes selected was hidden");
}

TEST_F(ReviewWindowTest, EnterMarksNothingThatTheViewStillFliesTo) {
  openFork();
  Camera aside = view().camera();
  aside.focus += 100 * aside.right();
  view().setCamera(aside);
  WindowTest::key(Qt::Key_Period);
  WindowTest::key(Qt::Key_Return); // at once
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Nothing is marked yet, as 2 of the 2"));
  key(Qt::Key_Return);
  EXPECT_EQ(document().undoStack().count(), 1);
}

TEST_F(ReviewWindowTest, EnterMarksNothingWhileTheSkeletonIsNotShown) {
  openFork();
  key(Qt::Key_F9);
  document().selection().set({shoot()});
  action("layer_skeleton").trigger();
  key(Qt::Key_Return);
  EXPECT_EQ(window().banner().text(),
            "Nothing is marked, as the skeleton is not shown: choose Skeleton (Ctrl+3)");
  EXPECT_EQ(document().undoStack().count(), 0);
  action("layer_skeleton").trigger();
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, AKeyThatIsHeldDownMarksOnce) {
  openFork();
  for (const char* id : {"mark_reviewed", "mark_doubtful", "mark_to_do"})
    EXPECT_FALSE(action(id).autoRepeat()) << id;
}

TEST_F(ReviewWindowTest, EnterMarksWhatLiesBehindWood) {
  open({writeScan("scan.xyz"), writeFork("fork.mtg")});
  key(Qt::Key_Period);
  ASSERT_TRUE(waitForStop()); // once it is known where errors are likely
  const std::vector<NodeId> stretch = chosen();
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(stretch.front()).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, TheWalkTakesSlabAndBoxAlong) {
  openFork();
  action("view_front").trigger();
  waitForView();
  const Clip thin{.slab = Clip::Slab{0, 0.1}, .box = {}};
  const Clip low{.slab = {},
                 .box =
                     Eigen::AlignedBox3d(Eigen::Vector3d(-2, -2, -1), Eigen::Vector3d(2, 2, 0.5))};
  for (const Clip& clip : {thin, low}) {
    view().setClip(clip);
    for (int stretch = 0; stretch < 4; ++stretch) {
      key(Qt::Key_Period);
      waitForView();
      for (const NodeId id : chosen())
        EXPECT_TRUE(isDrawn(id)) << label("review_place").toStdString();
    }
    EXPECT_NE(view().clip(), clip);
    EXPECT_FALSE(view().clip().isAll()) << "moved, not taken off";
  }
  EXPECT_EQ(document().undoStack().count(), 0) << "to look is no edit";
}

TEST_F(ReviewWindowTest, TheStatusLineSaysThatTheBoxWasMoved) {
  openFork();
  view().setClip(
      {.slab = {},
       .box = Eigen::AlignedBox3d(Eigen::Vector3d(-2, -2, -1), Eigen::Vector3d(2, 2, 0.5))});
  key(Qt::Key_Period); // along the trunk, which is 1 high
  EXPECT_EQ(window().statusLine().shownText(),
            "The box was moved to what you fly to   Alt+H shows all of the plant");
}

TEST_F(ReviewWindowTest, TheWalkShowsWhatWasHiddenAgain) {
  openFork();
  document().selection().set({shoot()});
  action("hide").trigger();
  ASSERT_FALSE(isDrawn(shoot()));
  key(Qt::Key_Period);
  EXPECT_FALSE(isDrawn(shoot())) << "it is not flown to yet";
  key(Qt::Key_Period);
  EXPECT_EQ(chosen(), std::vector{shoot()});
  waitForView();
  EXPECT_TRUE(isDrawn(shoot()));
}

TEST_F(ReviewWindowTest, ADoubtGoesOnAndNoEnterLeadsBackToIt) {
  openFork();
  key(Qt::Key_Period);
  const std::vector<NodeId> trunk = chosen();
  key(Qt::Key_Return, Qt::ShiftModifier);
  EXPECT_EQ(chosen(), std::vector{shoot()});
  for (int stretch = 0; stretch < 5; ++stretch) // two more than there are
    key(Qt::Key_Return);
  for (const NodeId id : document().skeleton().ids())
    EXPECT_EQ(markOf(id).state,
              std::ranges::count(trunk, id) > 0 ? ReviewState::doubtful : ReviewState::reviewed);
  EXPECT_EQ(window().statusLine().shownText(),
            "Nothing is to do; 2 nodes are doubtful: Ctrl+. walks there");
  key(Qt::Key_Period, Qt::ControlModifier);
  EXPECT_EQ(chosen(), trunk);
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(trunk.front()).state, ReviewState::doubtful) << "one is asked first";
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(trunk.front()).state, ReviewState::reviewed);
  EXPECT_EQ(window().statusLine().shownText(), "All is reviewed: the structure can be signed");
}

TEST_F(ReviewWindowTest, EnterMarksWhatIsToDoBesideADoubtAndLeavesThat) {
  openFork();
  key(Qt::Key_Period);
  const std::vector<NodeId> trunk = chosen();
  document().edit("Doubt", [&](SkeletonEditor& editor) {
    editor.setReview(trunk.back(), {.state = ReviewState::doubtful});
  });
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(trunk.front()).state, ReviewState::reviewed);
  EXPECT_EQ(markOf(trunk.back()).state, ReviewState::doubtful);
  EXPECT_EQ(chosen(), std::vector{shoot()});
}

TEST_F(ReviewWindowTest, EnterTakesAnOldDoubtBackOnlyIfItIsPressedTwice) {
  openFork();
  key(Qt::Key_F9);
  document().edit("Doubt", [&](SkeletonEditor& editor) {
    editor.setReview(shoot(),
                     {.state = ReviewState::doubtful, .comment = "crosses b", .reviewer = "Anna"});
  });
  document().selection().set({shoot()});
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::doubtful);
  EXPECT_EQ(window().statusLine().shownText(),
            QString("Node %1 is doubtful (Anna: crosses b): Enter once more takes that back and "
                    "marks it reviewed")
                .arg(indexOf(shoot())));
  document().selection().set({nodeAt({0, 0, 1})});
  document().selection().set({shoot()});
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::doubtful) << "it was left meanwhile";
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, EnterDoesNotReviewAWholePlantAtOnce) {
  openFork();
  key(Qt::Key_F9);
  action("select_all").trigger();
  key(Qt::Key_Return);
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_EQ(window().banner().text(),
            "Nothing is marked, as 5 nodes are more than one looks at in one go: walk to them by "
            "Next Not Reviewed (Ctrl+.), or choose Review > Mark All 5 Selected Reviewed");
  document().edit("Doubt", [&](SkeletonEditor& editor) {
    editor.setReview(shoot(), {.state = ReviewState::doubtful});
  });
  action("mark_all_selected").trigger();
  EXPECT_EQ(document().undoStack().undoText(), "Mark 4 nodes reviewed");
  for (const NodeId id : document().skeleton().ids())
    EXPECT_EQ(markOf(id).state, id == shoot() ? ReviewState::doubtful : ReviewState::reviewed);
  action("mark_all_selected").trigger();
  EXPECT_TRUE(window().banner().isVisible()) << "nothing of it is to do";
  key(Qt::Key_Z, Qt::ControlModifier);
  for (const NodeId id : document().skeleton().ids())
    EXPECT_NE(markOf(id).state, ReviewState::reviewed);
}

} // namespace
} // namespace espalier
