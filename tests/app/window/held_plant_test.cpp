// What keys do to a plant that is behind a preview, in the real window.
#include "tests/app/window/preview_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"

namespace espalier {
namespace {

/// Over a plant that was made from the scan, and edited since.
struct HeldPlantTest : test::PreviewTest {
  const QString reason = "This is a preview: Ctrl+R makes it the skeleton, Esc drops it";

  HeldPlantTest() {
    key(Qt::Key_R, Qt::ControlModifier);
    waitForJob();
    document().edit("Lift", [](SkeletonEditor& editor) {
      const NodeId root = editor.skeleton().roots().front();
      editor.setPosition(root, editor.skeleton()[root].position + Eigen::Vector3d(0, 0, 0.01));
    });
  }
  void showPreview() {
    turnOn();
    type("contract", "radius", 0.2);
    waitForPreview();
    view().setFocus();
  }
};

TEST_F(HeldPlantTest, KeysWarnThatItIsBehindAPreviewAndEditNothing) {
  showPreview();
  const Skeleton before = document().skeleton();
  for (const bool isSelected : {false, true}) {
    if (isSelected) document().selection().set({before.roots().front()});
    for (const Qt::Key pressed : {Qt::Key_Delete, Qt::Key_M, Qt::Key_N}) {
      key(pressed);
      EXPECT_EQ(window().statusLine().shownText(), reason) << pressed << isSelected;
    }
    for (const char* id : {"mark_doubtful", "comment", "smooth_radius"}) {
      find<QWidget>("message_banner").hide();
      action(id).trigger();
      EXPECT_EQ(window().banner().text(), reason) << id << isSelected;
    }
  }
  EXPECT_EQ(document().skeleton(), before);
  EXPECT_EQ(document().undoStack().count(), 2);
}

TEST_F(HeldPlantTest, IsEditedWhereItIsDrawnBesideThePreview) {
  showPreview();
  key(Qt::Key_9, Qt::ControlModifier);
  const std::size_t before = document().skeleton().size();
  document().selection().set({document().skeleton().roots().front()});
  hover({5, 5});
  key(Qt::Key_Delete);
  EXPECT_EQ(document().skeleton().size(), before - 1);
  key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier); // A takes its place
  document().selection().set({document().skeleton().roots().front()});
  key(Qt::Key_Delete);
  EXPECT_EQ(document().skeleton().size(), before - 1);
  EXPECT_EQ(window().statusLine().shownText(), reason);
}

TEST_F(HeldPlantTest, UndoAndRedoDropThePreviewFirst) {
  const Skeleton lifted = document().skeleton();
  const PipelineOptions options = panel().options();
  showPreview();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(shown());
  EXPECT_EQ(panel().options(), options);
  EXPECT_EQ(document().skeleton(), lifted);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(document().skeleton(), lifted);
  type("contract", "radius", 0.2);
  waitForPreview();
  view().setFocus();
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(shown());
  EXPECT_NE(document().skeleton(), lifted);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().skeleton(), lifted);
}

TEST_F(HeldPlantTest, PointsAreSetAsideAndBroughtBackBehindAPreview) {
  showPreview();
  document().leaveOut("Set aside", PointSet::of({1, 2}));
  waitForPreview();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().leftOut().isEmpty());
}

} // namespace
} // namespace espalier
