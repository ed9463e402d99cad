#include "core/base/error.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/line_scan.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/pick_root_tool.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::onPoint;

struct PickRootToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  PickRootTool tool{document, canvas};
  test::Mouse mouse{tool};

  void SetUp() override { document.setScan(test::lineScan(), "line.xyz"); }
};

TEST_F(PickRootToolTest, RootsThePlantAtThePointThatIsClicked) {
  const QSignalSpy finished(&tool, &Tool::finished);
  mouse.click(onPoint({0.3, 0, 3}), {0.3, 3});
  ASSERT_TRUE(document.root());
  EXPECT_TRUE(document.root()->isApprox(Eigen::Vector3d(0.3, 0, 3), 1e-6));
  EXPECT_EQ(finished.size(), 1) << "one root is enough";
  EXPECT_EQ(document.undoStack().count(), 0) << "the plant stays as it is";
}

TEST_F(PickRootToolTest, MeansThePointOfTheScanNearestToWhatIsDrawn) {
  document.openSkeleton(test::fork(3), "fork.mtg"); // its root at (0, 0, 0)
  mouse.click(test::onNode(test::forkRoot), {0, 0});
  ASSERT_TRUE(document.root());
  EXPECT_TRUE(document.root()->isApprox(Eigen::Vector3d(0, 0, 3), 1e-6)) << "no node is a point";
  mouse.click(onPoint({0.62, 0.05, 3}), {0.62, 3}); // contracted, as it is drawn
  EXPECT_TRUE(document.root()->isApprox(Eigen::Vector3d(0.6, 0, 3), 1e-6));
}

TEST_F(PickRootToolTest, ShowsWhereTheRootWouldBeAndTakesThatAway) {
  mouse.hover(onPoint({0.3, 0, 3}), {0.3, 3});
  ASSERT_EQ(canvas.preview.nodes.size(), 1U);
  EXPECT_FALSE(canvas.preview.label.isEmpty());
  mouse.hover({}, {5, 5});
  EXPECT_TRUE(canvas.preview.isEmpty());
  mouse.hover(onPoint({0.3, 0, 3}), {0.3, 3});
  tool.leave();
  EXPECT_TRUE(canvas.preview.isEmpty());
  EXPECT_FALSE(document.root());
}

TEST_F(PickRootToolTest, LeavesDragsToTheCamera) {
  EXPECT_FALSE(mouse.press(onPoint({0.3, 0, 3}), {0.3, 3}));
  EXPECT_FALSE(mouse.drag({1, 3}));
  mouse.release(onPoint({0.3, 0, 3}));
  EXPECT_FALSE(document.root());
}

TEST_F(PickRootToolTest, SaysWhatToClickOnEmptyGround) {
  mouse.press({}, {5, 5});
  EXPECT_THROW(mouse.release({}), Error);
  EXPECT_FALSE(document.root());
  document.setScan(nullptr, {});
  mouse.press(onPoint({0.3, 0, 3}), {0.3, 3});
  EXPECT_THROW(mouse.release(onPoint({0.3, 0, 3})), Error) << "of a structure without a scan";
}

TEST_F(PickRootToolTest, ForgetsTheRootOfAnotherScan) {
  mouse.click(onPoint({0.3, 0, 3}), {0.3, 3});
  document.setScan(test::lineScan(), "other.xyz");
  EXPECT_FALSE(document.root());
}

} // namespace
} // namespace espalier
