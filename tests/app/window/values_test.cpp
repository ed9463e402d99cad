#include "tests/app/window/window_fixture.h"
#include "ui/panels/explained_bar.h"
#include "ui/panels/option_slider.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

namespace espalier {
namespace {

/// What is shown of distances and other values.
struct ValuesWindowTest : test::WindowTest {
  void openForkAndScan() { open({writeScan("plant.xyz"), writeFork("fork.mtg")}); }
  QString left() { return find<QLabel>("explained_left").text(); }
  [[nodiscard]] bool waitForLeft(const QString& part) {
    return QTest::qWaitFor([&] { return left().contains(part); }, patience);
  }
  [[nodiscard]] QImage picture() { return view().picture({300, 300}); }
};

TEST_F(ValuesWindowTest, TheSliderLeavesWhatTheSkeletonDoesNotExplain) {
  openForkAndScan();
  const QImage all = picture();
  EXPECT_FALSE(find<ExplainedBar>("explained_bar").isVisible());
  key(Qt::Key_5, Qt::ControlModifier);
  EXPECT_TRUE(find<ExplainedBar>("explained_bar").isVisible());
  ASSERT_TRUE(waitForLeft("left"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return picture() != all; }, patience)) << "they are dimmed";
  const QImage dimmed = picture();
  find<QToolButton>("explained_hide").click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return picture() != dimmed; }, patience));
  auto& slider = find<OptionSlider>("explained_slider");
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_End);
  EXPECT_NEAR(find<QDoubleSpinBox>("explained_number").value(), // as far as it is written
              find<ExplainedBar>("explained_bar").distance(), 1e-4);
  find<QDoubleSpinBox>("explained_number").setValue(100); // beyond all of the plant
  EXPECT_TRUE(waitForLeft("0 left, 0.0 %"));
  clickButton("explained_close");
  EXPECT_FALSE(find<ExplainedBar>("explained_bar").isVisible());
  EXPECT_FALSE(action("hide_explained").isChecked());
  EXPECT_TRUE(QTest::qWaitFor([&] { return picture() == all; }, patience));
}

TEST_F(ValuesWindowTest, BarsOverTheViewCoverNeitherEachOtherNorTheMinimap) {
  openForkAndScan();
  view().setMinimapShown(true);
  action("hide_explained").setChecked(true);
  action("blend_points").setChecked(true);
  Camera near = view().camera();
  near.distance /= 8; // the minimap is absent while all is shown
  view().setCamera(near);
  auto* minimap = view().findChild<QWidget*>("minimap");
  ASSERT_TRUE(minimap != nullptr &&
              QTest::qWaitFor([&] { return minimap->isVisible(); }, patience));
  const auto placeOf = [&](const QString& name) {
    auto& widget = find<QWidget>(name);
    EXPECT_TRUE(widget.isVisible());
    return QRect(widget.mapTo(&window(), QPoint()), widget.size());
  };
  const QRect explained = placeOf("explained_bar");
  const QRect blend = placeOf("blend_bar");
  EXPECT_FALSE(explained.intersects(blend));
  const QRect map(minimap->mapTo(&window(), QPoint()), minimap->size());
  document().pointSelection().set(PointSet::of({0}));
  action("branch_from_points").trigger(); // of too few points
  waitForJob();
  const QRect message = placeOf("message_banner");
  for (const QRect& bar : {explained, blend}) {
    EXPECT_FALSE(bar.intersects(map));
    EXPECT_FALSE(bar.intersects(message));
  }
  EXPECT_FALSE(message.intersects(map));
}

TEST_F(ValuesWindowTest, TheSliderFollowsEdits) {
  openForkAndScan();
  action("hide_explained").setChecked(true);
  ASSERT_TRUE(waitForLeft("left"));
  const QString before = left();
  document().edit("Move", [&](SkeletonEditor& editor) {
    editor.setPosition(nodeAt({1, 0, 2}), {0.8, 0, 1.6}); // onto a branch of the scan
  });
  EXPECT_TRUE(QTest::qWaitFor([&] { return left() != before; }, patience));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return left() == before; }, patience));
}

TEST_F(ValuesWindowTest, WithoutASkeletonNothingIsExplained) {
  open({writeScan("plant.xyz")});
  const QImage all = picture();
  action("hide_explained").setChecked(true);
  EXPECT_EQ(left(), "no skeleton");
  EXPECT_EQ(picture(), all);
}

TEST_F(ValuesWindowTest, ColorsPointsByTheirDisplacement) {
  open({writeScan("plant.xyz")});
  const QImage byHeight = picture();
  action("color_displacement").trigger();
  EXPECT_EQ(picture(), byHeight) << "nothing is contracted yet";
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  action("layer_skeleton").setChecked(false);
  action("layer_contracted").setChecked(false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return picture() != byHeight; }, patience));
  action("color_height").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return picture() == byHeight; }, patience));
}

TEST_F(ValuesWindowTest, ColorsNodesByEachValue) {
  openForkAndScan();
  document().edit("Radius", [&](SkeletonEditor& editor) {
    editor.setRadius(nodeAt({1, 0, 2}), 0.05);
    editor.setReview(nodeAt({0, 0, 1}), {ReviewState::reviewed, "", "Anna"});
  });
  const QImage usual = picture();
  for (const char* id :
       {"order", "radius", "radius_to_parent", "review", "distance", "confidence"}) {
    action(QStringLiteral("node_color_%1").arg(id)).trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return picture() != usual; }, patience)) << id;
    action("node_color_none").trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return picture() == usual; }, patience)) << id;
  }
}

TEST_F(ValuesWindowTest, ColorsPointsByTheirDistanceUntilAnotherColorIsChosen) {
  openForkAndScan();
  const QImage byHeight = picture();
  action("color_distance").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return picture() != byHeight; }, patience));
  action("color_height").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return picture() == byHeight; }, patience));
}

TEST_F(ValuesWindowTest, ColorsAreRemembered) {
  openForkAndScan();
  action("node_color_order").trigger();
  action("color_distance").trigger();
  restart();
  EXPECT_TRUE(action("node_color_order").isChecked());
  EXPECT_TRUE(action("color_distance").isChecked());
  openForkAndScan();
  const QImage shown = picture();
  action("node_color_none").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return picture() != shown; }, patience));
}

} // namespace
} // namespace espalier
