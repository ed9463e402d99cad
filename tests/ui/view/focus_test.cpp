#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "tests/ui/view/stick_view.h"
#include "ui/view/focus.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A stem of 4 with a branch of 2 and a twig on that; and a branch of its own on the stem.
struct Plant {
  Skeleton skeleton = test::stick(5);
  NodeId branch =
      skeleton.add({.position = {1, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  NodeId twig =
      skeleton.add({.position = {1, 0, 3}, .parent = branch, .edge = EdgeType::branching});
  NodeId other =
      skeleton.add({.position = {-1, 0, 3}, .parent = NodeId{3}, .edge = EdgeType::branching});
};

TEST(Focus, HasTheBranchAndAllThatBearIt) {
  const Plant plant;
  const Focus focus = focusOn(plant.skeleton, {.nodes = {plant.twig}, .margin = 0.5});
  EXPECT_EQ(focus.branch, (std::vector<NodeId>{NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3},
                                               NodeId{4}, plant.branch, plant.twig}));
  EXPECT_TRUE(focus.box.contains(Vector3d(1, 0, 3)));
  EXPECT_FALSE(focus.box.contains(Vector3d(1, 0, 2)));
}

TEST(Focus, HasPlacesOnThePointsToo) {
  const Focus focus = focusOn(Plant().skeleton, {.nodes = {}, .places = {{0, 5, 1}, {0, 7, 1}}});
  EXPECT_EQ(focus.box.min(), Vector3d(0, 5, 1));
  EXPECT_EQ(focus.box.max(), Vector3d(0, 7, 1));
  EXPECT_TRUE(focus.branch.empty());
}

/// Looks along y at a box of side 1 about the origin, from 10 away.
Camera cameraAt(double distance) {
  Camera camera;
  camera.distance = distance;
  return camera;
}
Focus unitBox() {
  return {.box = {Vector3d::Constant(-0.5), Vector3d::Constant(0.5)}, .branch = {}};
}

TEST(FocusDepths, FadeWhatIsNotNearInDepth) {
  const FocusDepths depths(unitBox(), 0.8, cameraAt(10));
  EXPECT_EQ(depths.outOfFocus(10), 0);
  EXPECT_EQ(depths.outOfFocus(9.6), 0);
  EXPECT_DOUBLE_EQ(depths.outOfFocus(5), 0.8);
  EXPECT_DOUBLE_EQ(depths.outOfFocus(20), 0.8);
  EXPECT_GT(depths.outOfFocus(11), 0);
  EXPECT_LT(depths.outOfFocus(11), 0.8);
  EXPECT_TRUE(depths.isPassed(5));
  EXPECT_FALSE(depths.isPassed(10));
  EXPECT_FALSE(depths.isPassed(20)) << "it is behind anyway";
}

TEST(FocusDepths, FadeNothingWhereTheFocusIsSmallOnTheScreen) {
  const FocusDepths depths(unitBox(), 1, cameraAt(100));
  EXPECT_EQ(depths.outOfFocus(50), 0);
  EXPECT_FALSE(depths.isPassed(50));
  EXPECT_EQ(FocusDepths().outOfFocus(7), 0);
  EXPECT_FALSE(FocusDepths().isPassed(7));
}

TEST(FocusDepths, FadeNothingWhereTheFocusIsBehindTheEyeOrBesideTheScreen) {
  Camera past = cameraAt(1);
  past.focus = {0, 5, 0};
  EXPECT_EQ(FocusDepths(unitBox(), 1, past).outOfFocus(20), 0);
  Camera beside = cameraAt(10);
  beside.focus = {40, 0, 0};
  EXPECT_EQ(FocusDepths(unitBox(), 1, beside).outOfFocus(20), 0);
}

TEST(FocusDepths, PassNothingWhereHardlyAnythingIsPale) {
  const FocusDepths depths(unitBox(), 0.2, cameraAt(10));
  EXPECT_GT(depths.outOfFocus(5), 0);
  EXPECT_FALSE(depths.isPassed(5)) << "it is still drawn before the focus";
}

/// Two sticks, one before the other as seen from the front.
class FocusViewTest : public test::StickView {
protected:
  void SetUp() override {
    StickView::SetUp();
    for (int i = 0; i < 2; ++i)
      before_[i] = plant_.add({.position = {0.3, -6, 1.0 + 2 * i},
                               .parent = i == 0 ? std::nullopt : std::optional(before_[0]),
                               .edge = EdgeType::successor});
    view_.setSkeleton(plant_);
    view_.look(StandardView::front);
    view_.frameAll();
    view_.setCamera(view_.camera());
  }
  [[nodiscard]] int black(const Vector3d& place) {
    return test::countPixels(view_.picture(view_.size()), pixelOf(place), 4, test::black, 24);
  }
  NodeId before_[2];
};

TEST_F(FocusViewTest, DrawsPaleWhatIsBeforeTheBranchOneFlewTo) {
  const Vector3d ofOther(0.3, -6, 2);
  EXPECT_GT(black(ofOther), 0);
  const auto ofBranch = [this] {
    return view_.picture(view_.size()).pixel(pixelOf(Vector3d(0, 0, 1.5)).toPoint());
  };
  const QRgb before = ofBranch();
  const Sight sight{.nodes = {NodeId{0}, NodeId{4}}};
  view_.flyTo(view_.camera(), focusOn(plant_, sight));
  view_.setCamera(view_.camera());
  EXPECT_EQ(black(ofOther), 0);
  EXPECT_EQ(ofBranch(), before) << "the branch stays whole";
  view_.setFocusFade(0);
  EXPECT_GT(black(ofOther), 0);
  view_.setFocusFade(0.7);
  view_.frameAll();
  view_.setCamera(view_.camera());
  EXPECT_GT(black(ofOther), 0) << "all of the plant is looked at again";
}

TEST_F(FocusViewTest, PicksNoPointThatIsDrawnBehindWhatIsInFocus) {
  std::vector<Vector3d> places;
  for (int i = 0; i <= 40; ++i) {
    places.emplace_back(0, 0, 0.1 * i);
    places.emplace_back(0.3, -6, 0.1 * i);
  }
  view_.setCloud(test::cloudOf(places));
  view_.setLayerVisible(Layer::skeleton, false);
  const QPointF at = pixelOf(Vector3d(0.3, -6, 2));
  ASSERT_TRUE(view_.pick(at).point);
  view_.flyTo(view_.camera(), focusOn(plant_, {.nodes = {NodeId{0}, NodeId{4}}}));
  view_.setCamera(view_.camera());
  EXPECT_FALSE(view_.pick(at).point);
  EXPECT_TRUE(view_.pick(pixelOf(Vector3d(0, 0, 2.2))).point);
}

} // namespace
} // namespace espalier
