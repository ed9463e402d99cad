#include "tests/ui/view/stick_view.h"
#include "ui/view/in_view.h"

namespace espalier {
namespace {

class InViewTest : public test::StickView {
protected:
  void lookAt(const Eigen::Vector3d& focus, double distance) {
    Camera camera = view_.camera();
    camera.focus = focus;
    camera.distance = distance;
    view_.setCamera(camera);
  }
};

TEST_F(InViewTest, IsThePlantOrNothingThatCouldBe) {
  EXPECT_EQ(view_.inView(), InView::plant);
  view_.setSkeleton({});
  EXPECT_EQ(view_.inView(), InView::plant) << "there is none to miss";
}

TEST_F(InViewTest, IsAnEdgeWhoseNodesAreBesideTheScreen) {
  lookAt({0, 0, 1.5}, 0.2);
  EXPECT_EQ(view_.inView(), InView::plant);
  lookAt({1, 0, 1.5}, 0.2);
  EXPECT_EQ(view_.inView(), InView::beside);
}

TEST_F(InViewTest, IsNotWhatIsHiddenOrClipped) {
  view_.setClip(
      {.slab = {}, .box = Eigen::AlignedBox3d(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 2, 2))});
  EXPECT_EQ(view_.inView(), InView::clipped);
  view_.setClip({});
  view_.setHiddenNodes(plant_.ids());
  EXPECT_EQ(view_.inView(), InView::hidden);
  view_.setHiddenNodes({});
  view_.setLayerVisible(Layer::skeleton, false);
  EXPECT_EQ(view_.inView(), InView::layersOff);
}

TEST_F(InViewTest, IsAPointOfTheScan) {
  view_.setLayerVisible(Layer::skeleton, false);
  RawPoints raw;
  raw.positions = {{0, 0, 1}, {0, 0, 2}};
  view_.setCloud(std::make_shared<const PointCloud>(std::move(raw)));
  EXPECT_EQ(view_.inView(), InView::plant);
  view_.setPointStates(std::make_shared<const std::vector<PointState>>(2, PointState::hidden));
  EXPECT_EQ(view_.inView(), InView::hidden);
}

} // namespace
} // namespace espalier
