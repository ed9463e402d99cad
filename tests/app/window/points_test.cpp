// Points of the scan are selected, set aside, kept and grown into a branch, in the real window.
#include "core/io/formats.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"

#include <QMouseEvent>
#include <QTest>

#include <algorithm>

namespace espalier {
namespace {

/// Over the scan of a trunk of 2 m with three branches, one of them along +x, seen from the front.
class PointsTest : public test::ProjectWindowTest {
protected:
  void SetUp() override {
    open({writeScan("scan.xyz")});
    action("view_front").trigger();
    waitForView();
    key(Qt::Key_C);
  }

  [[nodiscard]] const PointCloud& cloud() { return *document().scan()->cloud(); }
  [[nodiscard]] PointSet chosen() { return document().pointSelection().points(); }
  [[nodiscard]] QPointF pixel(const Eigen::Vector3d& place) {
    return view().project(place).value();
  }
  template <class Accepts> PointSet pointsThat(Accepts accepts) {
    std::vector<Eigen::Index> points;
    for (Eigen::Index i = 0; i < cloud().size(); ++i)
      if (accepts(cloud().position(i))) points.push_back(i);
    return PointSet::of(points);
  }
  /// The branch along +x but for its foot.
  PointSet branch() {
    return pointsThat([](const Eigen::Vector3d& place) { return place.x() > 0.15; });
  }
  void press(const QPoint& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    hover(at);
    send(QEvent::MouseButtonPress, at, Qt::LeftButton, modifiers);
  }
  void moveTo(const QPoint& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    send(QEvent::MouseMove, at, Qt::NoButton, modifiers);
  }
  void release(const QPoint& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton, modifiers);
  }
  void stroke(const std::vector<QPoint>& places, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    press(places.front(), modifiers);
    for (const QPoint& place : places)
      moveTo(place, modifiers);
    release(places.back(), modifiers);
  }
  /// The polygon about the branch along +x, away from the trunk.
  std::vector<QPoint> aroundTheBranch() {
    std::vector<QPoint> corners;
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.15, 0, 0.9), {1, 0, 1.4}, {1, 0, 1.9}, {0.15, 0, 1.3}})
      corners.push_back(pixel(place).toPoint());
    return corners;
  }
  void waitForStates() { QTest::qWait(30); } // what is shown follows in the next round of events

private:
  void send(QEvent::Type type, const QPoint& at, Qt::MouseButton button,
            Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(type, QPointF(at), QPointF(view().mapToGlobal(at)), button, Qt::LeftButton,
                      modifiers);
    QCoreApplication::sendEvent(&view(), &event);
  }
};

TEST_F(PointsTest, TheBrushPaintsWhatLiesUnderItsRing) {
  const QPointF center = pixel({0.4, 0, 1.3});
  stroke({center.toPoint()});
  ASSERT_FALSE(chosen().isEmpty());
  for (const Eigen::Index point : chosen().points())
    EXPECT_LE(QLineF(center, pixel(cloud().position(point))).length(), 16 + 2);
  const std::size_t few = chosen().size();
  for (int i = 0; i < 4; ++i)
    key(Qt::Key_BracketRight);
  stroke({center.toPoint()});
  EXPECT_GT(chosen().size(), few) << "the brush has grown";
  for (int i = 0; i < 4; ++i)
    key(Qt::Key_BracketLeft);
  stroke({center.toPoint()});
  EXPECT_EQ(chosen().size(), few);
}

TEST_F(PointsTest, ABoxTakesWhatIsInItOrThroughAll) {
  key(Qt::Key_C, Qt::ShiftModifier);
  action("select_through").trigger();
  const QRectF box(pixel({0.2, 0, 1.7}), pixel({0.6, 0, 1.1}));
  stroke({box.topLeft().toPoint(), box.bottomRight().toPoint()});
  const auto isIn = [&](double margin) {
    return pointsThat([&](const Eigen::Vector3d& place) {
      return box.adjusted(-margin, -margin, margin, margin).contains(pixel(place));
    });
  };
  const PointSet all = chosen();
  EXPECT_FALSE(all.isEmpty());
  EXPECT_TRUE((isIn(-2) - all).isEmpty()) << "all that is in it";
  EXPECT_TRUE((all - isIn(2)).isEmpty()) << "and nothing beside it";
  action("select_through").trigger();
  stroke({box.topLeft().toPoint(), box.bottomRight().toPoint()});
  EXPECT_FALSE(chosen().isEmpty());
  EXPECT_TRUE((chosen() - all).isEmpty());
  EXPECT_LT(chosen().size(), all.size()) << "the back of the branch is behind its front";
  stroke({box.topLeft().toPoint(), box.bottomRight().toPoint()},
         Qt::ShiftModifier | Qt::ControlModifier);
  EXPECT_EQ(chosen(), all) << "Ctrl takes all, however deep";
}

TEST_F(PointsTest, ALassoAddsWithShiftAndTakesAwayWithAlt) {
  key(Qt::Key_C, Qt::ShiftModifier);
  key(Qt::Key_C, Qt::ShiftModifier);
  stroke(aroundTheBranch());
  const PointSet ofBranch = chosen();
  ASSERT_FALSE(ofBranch.isEmpty());
  for (const Eigen::Index point : ofBranch.points())
    EXPECT_GT(cloud().position(point).x(), 0.1);
  const QPoint trunk = pixel({0, 0, 0.4}).toPoint();
  const QPoint side(25, 0);
  const QPoint below(0, 25);
  stroke({trunk - side, trunk + below, trunk + side, trunk - below}, Qt::ShiftModifier);
  EXPECT_GT(chosen().size(), ofBranch.size());
  EXPECT_EQ(chosen() & ofBranch, ofBranch);
  stroke(aroundTheBranch(), Qt::AltModifier);
  EXPECT_TRUE((chosen() & ofBranch).isEmpty());
  EXPECT_FALSE(chosen().isEmpty()) << "the trunk stays";
}

TEST_F(PointsTest, EscapeInAStrokeLeavesTheSelectionAsItWas) {
  const QPoint tip = pixel({0.7, 0, 1.52}).toPoint();
  stroke({tip});
  const PointSet before = chosen();
  press(pixel({0, 0, 0.4}).toPoint());
  moveTo(pixel({0, 0, 0.8}).toPoint());
  EXPECT_NE(chosen(), before);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(chosen(), before);
  release(pixel({0, 0, 0.8}).toPoint());
  EXPECT_EQ(chosen(), before);
  EXPECT_TRUE(action("tool_points").isChecked());
}

TEST_F(PointsTest, DelSetsPointsAsideAndUndoBringsThemBack) {
  document().edit("Add", [](SkeletonEditor& editor) { (void)editor.add({}); });
  document().selection().set(document().skeleton().ids());
  const Skeleton plant = document().skeleton();
  const int steps = document().undoStack().count();
  stroke({pixel({0.3, 0, 1.2}).toPoint(), pixel({0.7, 0, 1.5}).toPoint()});
  const PointSet painted = chosen();
  ASSERT_FALSE(painted.isEmpty());
  key(Qt::Key_Delete);
  EXPECT_EQ(document().leftOut(), painted);
  EXPECT_TRUE(chosen().isEmpty());
  EXPECT_EQ(document().skeleton(), plant) << "Del meant the points";
  EXPECT_EQ(document().undoStack().count(), steps + 1);
  EXPECT_TRUE(document().undoStack().undoText().startsWith("Set "));
  EXPECT_TRUE(window().statusLine().counts().contains("set aside"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().leftOut().isEmpty());
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().leftOut(), painted);
  key(Qt::Key_S); // another tool: Del is the nodes' again
  key(Qt::Key_Delete);
  EXPECT_TRUE(document().skeleton().isEmpty());
  EXPECT_EQ(document().leftOut(), painted);
}

TEST_F(PointsTest, ShiftDelKeepsOnlyThePointsSelected) {
  stroke({pixel({0.3, 0, 1.2}).toPoint(), pixel({0.7, 0, 1.5}).toPoint()});
  const PointSet painted = chosen();
  key(Qt::Key_Delete, Qt::ShiftModifier);
  EXPECT_EQ(document().leftOut(), PointSet::firstOf(cloud().size()) - painted);
  action("bring_points_back").trigger();
  EXPECT_TRUE(document().leftOut().isEmpty());
  EXPECT_FALSE(action("bring_points_back").isEnabled());
}

TEST_F(PointsTest, PointsSetAsideAreNotSeenUnlessTheyAreShown) {
  document().pointSelection().set(branch());
  key(Qt::Key_Delete);
  waitForStates();
  const QRectF box(pixel({0.2, 0, 1.7}), pixel({0.7, 0, 1.1}));
  EXPECT_TRUE(view().pointsInside(QPolygonF(box), Depth::through).empty());
  action("show_set_aside").trigger();
  waitForStates();
  const PointSet shown = PointSet::of(view().pointsInside(QPolygonF(box), Depth::through));
  EXPECT_FALSE(shown.isEmpty());
  EXPECT_EQ(action("bring_points_back").text(), "Bring All Back");
  document().pointSelection().set(PointSet::firstOf(cloud().size()) - branch());
  action("bring_points_back").trigger();
  EXPECT_EQ(document().leftOut(), branch()) << "none of those selected is set aside";
  document().pointSelection().set(shown);
  EXPECT_EQ(action("bring_points_back").text(), "Bring These Back");
  action("bring_points_back").trigger();
  EXPECT_EQ(document().leftOut(), branch() - shown) << "those selected";
  action("show_set_aside").trigger();
}

TEST_F(PointsTest, IsolatedPointsAreAloneUntilAllAreShownAgain) {
  document().pointSelection().set(branch());
  action("isolate_points").trigger();
  waitForStates();
  const QPolygonF all(QRectF(view().rect()));
  EXPECT_EQ(PointSet::of(view().pointsInside(all, Depth::through)), branch());
  EXPECT_EQ(document().undoStack().count(), 0) << "no edit";
  ASSERT_TRUE(action("show_all").isEnabled());
  action("show_all").trigger();
  waitForStates();
  EXPECT_EQ(PointSet::of(view().pointsInside(all, Depth::through)),
            PointSet::firstOf(cloud().size()));
  EXPECT_FALSE(action("show_all").isEnabled());
}

TEST_F(PointsTest, AReconstructionSeesNothingOfWhatIsSetAside) {
  const auto farthest = [this] {
    double x = 0;
    for (const NodeId id : document().skeleton().ids())
      x = std::max(x, document().skeleton()[id].position.x());
    return x;
  };
  document().pointSelection().set(branch());
  key(Qt::Key_Delete);
  action("reconstruct").trigger();
  waitForJob();
  ASSERT_FALSE(document().skeleton().isEmpty());
  EXPECT_LT(farthest(), 0.2);
  action("bring_points_back").trigger();
  action("reconstruct").trigger();
  waitForJob();
  EXPECT_GT(farthest(), 0.7);
}

TEST_F(PointsTest, AProjectKeepsWhatIsSetAsideAsItHappens) {
  const QString file = saveProject("plant.espalier");
  document().pointSelection().set(branch());
  key(Qt::Key_Delete);
  EXPECT_EQ(onDisk(file), document().history()) << "at once: a crash loses nothing";
  EXPECT_EQ(onDisk(file).leftOut, branch());
  restart();
  open({file});
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().leftOut(), branch());
  EXPECT_EQ(document().scan()->leftOut(), branch());
  action("undo").trigger();
  EXPECT_TRUE(document().leftOut().isEmpty());
  EXPECT_EQ(onDisk(file), document().history());
}

TEST_F(PointsTest, AreExportedButForThoseThatAreSetAside) {
  document().pointSelection().set(branch());
  key(Qt::Key_Delete);
  const Eigen::Index kept = cloud().size() - static_cast<Eigen::Index>(branch().size());
  answer(chooseFile(path("kept.ply")), [this] { action("export_points").trigger(); });
  waitForJob();
  EXPECT_EQ(readPoints(path("kept.ply").toStdString()).value.size(), kept);
  EXPECT_TRUE(window().banner().text().contains("kept.ply"));
}

TEST_F(PointsTest, AReadOnlyPlantLetsPointsBeSelectedAndNothingElse) {
  document().setReadOnly("it is signed");
  EXPECT_TRUE(action("tool_points").isChecked());
  stroke({pixel({0.4, 0, 1.3}).toPoint()});
  EXPECT_FALSE(chosen().isEmpty());
  key(Qt::Key_Delete);
  EXPECT_FALSE(action("set_points_aside").isEnabled());
  EXPECT_TRUE(document().leftOut().isEmpty());
}

TEST_F(PointsTest, ABranchGrowsFromThePointsSelected) {
  document().pointSelection().set(branch());
  key(Qt::Key_Delete);
  action("reconstruct").trigger(); // of all but the branch
  waitForJob();
  action("bring_points_back").trigger();
  const Skeleton before = document().skeleton();
  action("branch_from_points").trigger(); // no point is selected
  EXPECT_TRUE(window().statusLine().shownText().contains("Select Points (C)"))
      << window().statusLine().shownText().toStdString();
  document().pointSelection().set(branch());
  action("branch_from_points").trigger();
  waitForJob();
  ASSERT_TRUE(QTest::qWaitFor([this] { return action("accept").isEnabled(); }, patience));
  EXPECT_EQ(document().skeleton(), before) << "changed before it was accepted";
  key(Qt::Key_Return);
  EXPECT_EQ(document().skeleton().roots().size(), 1U);
  double nearest = 1;
  for (const NodeId id : document().skeleton().ids())
    nearest = std::min(nearest,
                       (document().skeleton()[id].position - Eigen::Vector3d(0.8, 0, 1.6)).norm());
  EXPECT_LT(nearest, 0.1) << "it reaches the tip";
  EXPECT_TRUE(action("tool_points").isChecked()) << "back to the tool before";
  action("undo").trigger();
  EXPECT_EQ(document().skeleton(), before);
}

} // namespace
} // namespace espalier
