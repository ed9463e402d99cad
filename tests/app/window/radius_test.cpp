#include "core/io/formats.h"
#include "tests/app/window/window_fixture.h"
#include "ui/panels/cross_section_view.h"
#include "ui/panels/message_banner.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTest>

namespace espalier {
namespace {

/// The trunk of writeScan(), 0.05 thick, and a skeleton that goes on above it.
struct RadiusWindowTest : test::WindowTest {
  static constexpr int last = 13; // nodes 0.2 apart; the trunk ends at node 10

  void SetUp() override {
    Skeleton trunk;
    std::optional<NodeId> parent;
    for (int i = 0; i <= last; ++i)
      parent = trunk.add({.position = {0, 0, 0.2 * i}, .radius = 0.03, .parent = parent});
    writeStructure(path("trunk.mtg").toStdString(), trunk);
    open({writeScan("scan.xyz"), path("trunk.mtg")});
  }
  NodeId node(int i) { return nodeAt({0, 0, 0.2 * i}); }
  double radius(int i) { return document().skeleton()[node(i)].radius; }
  CrossSectionView& section() { return find<CrossSectionView>("cross_section"); }
  void moveTo(const Eigen::Vector2d& place) {
    const QPointF at = section().toScreen(place);
    QMouseEvent event(QEvent::MouseMove, at, section().mapToGlobal(at), Qt::NoButton,
                      Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&section(), &event);
  }
};

TEST_F(RadiusWindowTest, AClickShowsTheSectionAndADragOfItsRimSetsTheRadius) {
  const NodeId id = node(3);
  click(placeOf(id));
  ASSERT_TRUE(section().isVisible());
  ASSERT_TRUE(section().section().has_value());
  const double before = radius(3);
  QTest::mousePress(&section(), Qt::LeftButton, {}, section().toScreen({before, 0}).toPoint());
  moveTo({0.04, 0});
  moveTo({0.05, 0});
  EXPECT_NEAR(radius(3), 0.05, 0.002);
  QTest::mouseRelease(&section(), Qt::LeftButton, {}, section().toScreen({0.05, 0}).toPoint());
  EXPECT_EQ(document().undoStack().count(), 1);
  action("undo").trigger();
  EXPECT_EQ(radius(3), before);
}

TEST_F(RadiusWindowTest, EscapeInADragOfTheCenterRestoresThePlant) {
  click(placeOf(node(3)));
  const Skeleton before = document().skeleton();
  QTest::mousePress(&section(), Qt::LeftButton, {}, section().toScreen({0, 0}).toPoint());
  moveTo({0.02, 0.01});
  EXPECT_NE(document().skeleton(), before);
  QTest::keyClick(&section(), Qt::Key_Escape);
  EXPECT_EQ(document().skeleton(), before);
  EXPECT_EQ(document().selection().nodes().size(), 1U) << "Escape left the drag alone";
}

TEST_F(RadiusWindowTest, SetsTheRadiusOfASelectionAndReportsWhatItCouldNot) {
  document().selection().set({node(1), node(2), node(3), node(last)});
  action("radius_circle").trigger();
  for (const int i : {1, 2, 3})
    EXPECT_NEAR(radius(i), 0.05, 0.003);
  EXPECT_NEAR(radius(last), 0.03, 1e-6) << "there are no points";
  EXPECT_EQ(document().undoStack().count(), 1);
  EXPECT_EQ(document().undoStack().undoText(), "Set the radius of 3 nodes by circle");
  EXPECT_TRUE(window().banner().isVisible());
  action("undo").trigger();
  EXPECT_NEAR(radius(1), 0.03, 1e-6);
}

TEST_F(RadiusWindowTest, MeasuresByEachMeasure) {
  const std::pair<const char*, double> measures[] = {
      {"radius_mean", 0.05}, {"radius_maximum", 0.05}, {"radius_hull", 0.05}};
  for (const auto& [id, expected] : measures) {
    document().selection().set({node(2)});
    action(id).trigger();
    EXPECT_NEAR(radius(2), expected, 0.006) << id;
    action("undo").trigger();
  }
}

TEST_F(RadiusWindowTest, SaysWhenNothingCouldBeMeasured) {
  document().selection().set({node(last)});
  action("radius_circle").trigger();
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(window().banner().isVisible());
}

TEST_F(RadiusWindowTest, MeasuresManyNodesAsAJobAndOneStep) {
  document().edit("Refine", [](SkeletonEditor& editor) {
    NodeId top = editor.skeleton().ids().back();
    for (int i = 0; i < 80; ++i) // up and down the trunk again
      top = editor.add({.position = {0, 0, 0.2 + 0.005 * i}, .radius = 0.01, .parent = top});
  });
  document().selection().set(document().skeleton().ids());
  action("radius_circle").trigger();
  EXPECT_TRUE(window().jobs().isBusy());
  EXPECT_FALSE(action("radius_circle").isEnabled());
  waitForJob();
  EXPECT_EQ(document().undoStack().count(), 2);
  EXPECT_NEAR(radius(2), 0.05, 0.003);
  EXPECT_TRUE(window().banner().isVisible());
  EXPECT_TRUE(action("radius_circle").isEnabled());
}

TEST_F(RadiusWindowTest, ModelsSmoothsAndLimits) {
  document().selection().set({node(0)});
  action("pipe_model").trigger();
  EXPECT_NEAR(radius(0), 0.03, 1e-6);
  document().edit("Bump", [&](SkeletonEditor& editor) { editor.setRadius(node(5), 0.06); });
  document().selection().set({node(5)});
  action("smooth_radius").trigger();
  EXPECT_NEAR(radius(5), (0.06 + 0.03) / 2, 1e-6);
  action("limit_radius").trigger();
  EXPECT_NEAR(radius(5), 0.03, 1e-6);
  const int steps = document().undoStack().count();
  action("limit_radius").trigger();
  EXPECT_EQ(document().undoStack().count(), steps) << "there is nothing left to limit";
}

// The trunk is 0.05 thick: node 3 was measured, the others are far from what the points show.
TEST_F(RadiusWindowTest, KeepsConfirmedRadiiInAPipeModel) {
  document().edit("Prepare", [&](SkeletonEditor& editor) {
    editor.setRadius(node(0), 0.2);
    editor.setRadius(node(3), 0.05);
    editor.setRadius(node(last), 0.02);
  });
  document().selection().set({node(0)});
  action("pipe_measured").trigger();
  EXPECT_NEAR(radius(3), 0.05, 1e-6);
  EXPECT_GT(radius(1), 0.1) << "by the model from the foot";
  EXPECT_LT(radius(4), 0.05) << "by the model from node 3";
  EXPECT_NEAR(radius(last), 0.02, 1e-6);
}

TEST_F(RadiusWindowTest, SaysWhatToDoWithoutASelection) {
  document().selection().clear();
  action("smooth_radius").trigger();
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(window().banner().isVisible());
}

TEST_F(RadiusWindowTest, OffersMeasuresOverAScanOnly) {
  EXPECT_TRUE(action("radius_circle").isEnabled());
  document().setScan(nullptr, "");
  EXPECT_FALSE(action("radius_circle").isEnabled());
  EXPECT_TRUE(action("smooth_radius").isEnabled());
  document().setReadOnly("it is signed");
  EXPECT_FALSE(action("smooth_radius").isEnabled());
}

TEST_F(RadiusWindowTest, HasAMenu) {
  for (const QAction* menu : window().menuBar()->actions())
    if (menu->text().remove('&') == "Radius") {
      EXPECT_TRUE(menu->menu()->actions().contains(&action("radius_circle")));
      EXPECT_TRUE(menu->menu()->actions().contains(&action("radius_up")));
      return;
    }
  ADD_FAILURE() << "no Radius menu";
}

} // namespace
} // namespace espalier
