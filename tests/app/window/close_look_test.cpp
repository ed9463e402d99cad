// One key looks closely at what is under the pointer, and another goes back, in the real window.
#include "app/window/view/close_look_flow.h"
#include "tests/app/window/window_fixture.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QApplication>
#include <QEnterEvent>
#include <QSlider>
#include <QTest>

#include <algorithm>

namespace espalier {
namespace {

class CloseLookTest : public test::WindowTest {
protected:
  CloseLookTest() {
    open({writeScan("scan.xyz"), writeFork("fork.mtg")});
    key(Qt::Key_Home);
    waitForView();
  }
  [[nodiscard]] QPoint corner() const { return {4, 4}; }
  void enter() {
    QEnterEvent event({1, 1}, {1, 1}, {1, 1});
    QApplication::sendEvent(&view(), &event);
  }
  void leave() {
    QEvent event(QEvent::Leave);
    QApplication::sendEvent(&view(), &event);
  }
};

TEST_F(CloseLookTest, FadesWhatIsAroundAsFarAsTheSliderSaysAndKeepsIt) {
  document().edit("Grow to the back", [](SkeletonEditor& editor) {
    for (const double x : {0.7, 1.0, 1.3}) { // behind the shoot that is looked at
      const NodeId foot = editor.add({.position = {x, 6, 1.5}});
      editor.add({.position = {x, 6, 2.5}, .parent = foot});
    }
  });
  action("show_clipping").trigger();
  auto& around = find<QSlider>("clip_around");
  EXPECT_GT(around.value(), 0) << "at first";
  hover(placeOf(nodeAt({1, 0, 2})));
  key(Qt::Key_Z);
  waitForView();
  const QSize size(300, 200);
  const QImage faded = view().picture(size);
  around.setValue(0);
  EXPECT_NE(view().picture(size), faded);
  around.setValue(around.maximum());
  EXPECT_DOUBLE_EQ(view().focusFade(), 1);
  key(Qt::Key_Home);
  waitForView();
  const QImage all = view().picture(size);
  around.setValue(0);
  EXPECT_EQ(view().picture(size), all) << "nothing is in focus any more";
  restart();
  EXPECT_DOUBLE_EQ(view().focusFade(), 0);
}

TEST_F(CloseLookTest, ShowsTheNodeUnderThePointerAndItsNeighbors) {
  const NodeId root = nodeAt({0, 0, 0});
  const Camera before = view().camera();
  hover(placeOf(root));
  key(Qt::Key_Z);
  waitForView();
  EXPECT_NE(view().camera(), before);
  const double margin = 5 * (1 + 3 * std::sqrt(2.0)) / 4; // mean edges: one of 1, three at 45°
  EXPECT_LT((view().camera().focus - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-6)
      << "the root and its child";
  EXPECT_NEAR(view().camera().halfHeight(), (0.5 + margin) * 1.08, 0.15 * margin);
  EXPECT_EQ(document().undoStack().count(), 0) << "to look is no edit";
}

TEST_F(CloseLookTest, ShowsWhatIsSelectedWhereThePointerIsOnNothing) {
  const NodeId root = nodeAt({0, 0, 0});
  document().selection().set({root});
  hover(corner());
  key(Qt::Key_Z);
  waitForView();
  EXPECT_LT((view().camera().focus - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-6);
}

TEST_F(CloseLookTest, ShowsWhatThePointerIsBesideRatherThanWhatIsSelectedElsewhere) {
  const NodeId root = nodeAt({0, 0, 0});
  const QPoint place = placeOf(root);
  document().selection().set({nodeAt({1, 0, 2})});
  const QPoint beside = place + QPoint(0, 25); // below the foot, where nothing is
  ASSERT_FALSE(view().pick(beside).node || view().pick(beside).edge || view().pick(beside).point);
  enter();
  hover(beside);
  key(Qt::Key_Z);
  waitForView();
  EXPECT_LT((view().camera().focus - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-6);
  key(Qt::Key_Z, Qt::ShiftModifier);
  waitForView();
  leave(); // to a panel: the selection is meant
  key(Qt::Key_Z);
  waitForView();
  EXPECT_GT((view().camera().focus - Eigen::Vector3d(0, 0, 0.5)).norm(), 0.5);
}

TEST_F(CloseLookTest, GoesBackStepByStep) {
  const Camera first = view().camera();
  hover(placeOf(nodeAt({0, 0, 0})));
  key(Qt::Key_Z);
  waitForView();
  const Camera second = view().camera();
  document().selection().set({nodeAt({1, 0, 2})});
  hover(corner());
  key(Qt::Key_Z);
  waitForView();
  EXPECT_NE(view().camera(), second);
  key(Qt::Key_Z, Qt::ShiftModifier);
  waitForView();
  EXPECT_EQ(view().camera(), second);
  key(Qt::Key_Z, Qt::ShiftModifier);
  waitForView();
  EXPECT_EQ(view().camera(), first);
  key(Qt::Key_Z, Qt::ShiftModifier);
  EXPECT_EQ(view().camera(), first);
  EXPECT_TRUE(window().statusLine().shownText().contains("no view to go back to"));
}

TEST_F(CloseLookTest, SaysThatThereIsNothingToLookAt) {
  const Camera before = view().camera();
  hover(corner());
  key(Qt::Key_Z);
  EXPECT_EQ(view().camera(), before);
  EXPECT_TRUE(window().statusLine().shownText().contains("pointer on the plant"));
}

// The branch of the scan toward (0.8, 0, 1.6), of which the skeleton has nothing.
TEST_F(CloseLookTest, ShowsAllOfABranchThatIsMissing) {
  Skeleton trunk;
  const NodeId foot = trunk.add({.position = {0, 0, 0}, .radius = 0.05});
  const NodeId bearer = trunk.add({.position = {0, 0, 1}, .radius = 0.05, .parent = foot});
  trunk.add({.position = {0, 0, 2}, .radius = 0.05, .parent = bearer});
  const Pick pick{.node = {}, .edge = {}, .point = Eigen::Vector3d(0.4, 0.02, 1.3)};
  const Sight sight = sightOf(trunk, pick, document().scan());
  double atFoot = 1;
  double atTip = 1;
  for (const Eigen::Vector3d& place : sight.places) {
    atFoot = std::min(atFoot, (place - Eigen::Vector3d(0, 0, 1)).norm());
    atTip = std::min(atTip, (place - Eigen::Vector3d(0.8, 0, 1.6)).norm());
    EXPECT_GT(place.x(), 0.03) << "the trunk is explained, and so is the other side";
  }
  EXPECT_LT(atFoot, 0.2);
  EXPECT_LT(atTip, 0.1);
  EXPECT_TRUE(std::ranges::find(sight.nodes, bearer) != sight.nodes.end());
  EXPECT_EQ(sightOf(trunk, pick, nullptr).places.size(), 1U) << "without a scan";
  const Pick onTrunk{.node = {}, .edge = {}, .point = Eigen::Vector3d(0.05, 0, 0.5)};
  EXPECT_EQ(sightOf(trunk, onTrunk, document().scan()).places.size(), 1U);
}

TEST_F(CloseLookTest, ShowsAPointOfAScanWithoutASkeleton) {
  const double spacing = document().scan()->spacing();
  const Pick pick{.point = Eigen::Vector3d(0, 0, 1), .pointOfThing = Eigen::Vector3d(0, 0.5, 1)};
  const Sight sight = sightOf(Skeleton(), pick, document().scan());
  ASSERT_EQ(sight.places.size(), 1U);
  EXPECT_EQ(sight.places.front(), Eigen::Vector3d(0, 0.5, 1)) << "the thing, not a stray before it";
  EXPECT_EQ(sight.margin, 45 * spacing);
  EXPECT_TRUE(sightOf(Skeleton(), {}, document().scan()).isEmpty());
}

} // namespace
} // namespace espalier
