#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/moved_clip.h"
#include "ui/view/palette.h"
#include "ui/view/plant_view.h"

#include <QTest>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <vector>

namespace espalier {
namespace {

Eigen::AlignedBox3d boxOf(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return {low, high};
}

TEST(ClipVolume, HoldsEverythingWithoutAClip) {
  const ClipVolume volume({}, boxOf({0, 0, 0}, {1, 1, 1}), {0, 0, 0}, Camera());
  EXPECT_TRUE(volume.isAll());
  EXPECT_TRUE(volume.contains({1e9F, 0, 0}));
}

// The camera looks along y from y = -9; the plant reaches from y = 0 to y = 10.
TEST(ClipVolume, CutsASlabOfTheDepthOfThePlant) {
  Camera camera;
  camera.focus = {0, -8, 0};
  const Eigen::Vector3d origin(0, 100, 0);
  const auto bounds = boxOf({-1, 0, -1}, {1, 10, 1});
  const ClipVolume volume({.slab = Clip::Slab{0.2, 0.5}, .box = {}}, bounds, origin, camera);
  const auto holds = [&](double y) {
    return volume.contains(Eigen::Vector3d(5, y - 100, 5).cast<float>());
  };
  EXPECT_FALSE(holds(1.9));
  EXPECT_TRUE(holds(2.1));
  EXPECT_TRUE(holds(4.9));
  EXPECT_FALSE(holds(5.1));
}

TEST(ClipVolume, TurnsItsSlabWithTheCamera) {
  Camera camera;
  camera.face(StandardView::right); // looks along -x
  const ClipVolume volume({.slab = Clip::Slab{0, 0.5}, .box = {}}, boxOf({-1, 0, -1}, {1, 10, 1}),
                          {0, 0, 0}, camera);
  EXPECT_TRUE(volume.contains({0.5F, 9, 0}));
  EXPECT_FALSE(volume.contains({-0.5F, 1, 0}));
}

TEST(ClipVolume, CutsABoxAboutAnyOrigin) {
  const Eigen::Vector3d origin(1e6, 0, 0);
  const ClipVolume volume({.slab = {}, .box = boxOf({1e6, 0, 0}, {1e6 + 1, 1, 1})}, {}, origin,
                          Camera());
  EXPECT_TRUE(volume.contains({0.5F, 0.5F, 0.5F}));
  EXPECT_FALSE(volume.contains({1.5F, 0.5F, 0.5F}));
}

// The camera looks along y; the plant reaches from y = 0 to y = 10.
TEST(MovedToShow, MovesASlabNoFartherThanItMust) {
  const auto bounds = boxOf({-1, 0, -1}, {1, 10, 1});
  const auto shows = [&](const Clip::Slab& slab, const std::vector<Eigen::Vector3d>& places) {
    return *movedToShow({.slab = slab, .box = {}}, places, bounds, Camera()).slab;
  };
  EXPECT_EQ(shows({0.2, 0.5}, {{0, 3, 0}}), (Clip::Slab{0.2, 0.5})) << "it is shown already";
  const Clip::Slab back = shows({0.2, 0.5}, {{0, 7, 0}});
  EXPECT_NEAR(back.farthest, 0.72, 1e-9) << "with a little of what is around it";
  EXPECT_NEAR(back.farthest - back.nearest, 0.3, 1e-9);
  const Clip::Slab front = shows({0.2, 0.5}, {{0, 0, 0}});
  EXPECT_NEAR(front.nearest, 0, 1e-9);
  EXPECT_NEAR(front.farthest, 0.3, 1e-9);
  const Clip::Slab wide = shows({0.2, 0.3}, {{0, 1, 0}, {0, 9, 0}});
  EXPECT_LE(wide.nearest, 0.1);
  EXPECT_GE(wide.farthest, 0.9);
  EXPECT_EQ(shows({0.2, 0.3}, {}), (Clip::Slab{0.2, 0.3}));
}

TEST(MovedToShow, MovesABoxAlongAndEnlargesItOnlyWhereItMust) {
  const auto bounds = boxOf({0, 0, 0}, {10, 10, 10});
  const Clip clip{.slab = {}, .box = boxOf({1, 1, 1}, {3, 3, 3})};
  const auto shown = [&](const std::vector<Eigen::Vector3d>& places) {
    return *movedToShow(clip, places, bounds, Camera()).box;
  };
  EXPECT_TRUE(shown({{2, 2, 2}}).isApprox(*clip.box));
  EXPECT_TRUE(shown({{6, 2, 2}}).isApprox(boxOf({4.2, 1, 1}, {6.2, 3, 3})));
  const Eigen::AlignedBox3d large = shown({{6, 2, 0}, {9, 2, 0}});
  EXPECT_TRUE(large.contains(Eigen::Vector3d(6, 2, 0)) && large.contains(Eigen::Vector3d(9, 2, 0)));
  EXPECT_NEAR(large.sizes().y(), 2, 1e-9);
  EXPECT_NEAR(large.sizes().z(), 2, 1e-9);
}

TEST(MovedToShow, LeavesAViewWithoutAClipAlone) {
  EXPECT_TRUE(movedToShow({}, {{0, 0, 0}}, boxOf({0, 0, 0}, {1, 1, 1}), Camera()).isAll());
}

/// A stick of five nodes along z with a point beside each node, seen from the front.
class ClipTest : public testing::Test {
protected:
  ClipTest() : plant_(test::stick(5)) {
    view_.resize(400, 300);
    view_.setDark(false);
    std::vector<Eigen::Vector3d> points;
    for (int z = 0; z < 5; ++z)
      points.emplace_back(1, 0, z);
    view_.setCloud(test::cloudOf(points));
    view_.setPointColor(PointColor::uniform);
    view_.setPointSize(6);
    view_.setSkeleton(plant_);
    view_.frameAll();
    view_.show();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  }
  [[nodiscard]] QPointF pixelOf(const Eigen::Vector3d& place) const {
    return view_.project(place).value();
  }
  [[nodiscard]] int count(const Eigen::Vector3d& place, const Color& color) {
    return test::countPixels(view_.picture(view_.size()), pixelOf(place), 4, color, 24);
  }
  /// Only what is from z = 0.5 to z = 2.5.
  void clipHeight() { view_.setClip({.slab = {}, .box = boxOf({-9, -9, 0.5}, {9, 9, 2.5})}); }

  Skeleton plant_;
  PlantView view_;
  const QPolygonF everything_{QRectF(0, 0, 400, 300)};
};

TEST_F(ClipTest, DrawsOnlyWhatIsInTheBox) {
  clipHeight();
  for (int z = 0; z < 5; ++z) {
    const bool isInside = z == 1 || z == 2;
    EXPECT_EQ(count({1, 0, double(z)}, test::plain) > 5, isInside) << "the point at " << z;
    EXPECT_EQ(count({0, 0, double(z)}, test::black) > 5, isInside) << "the node at " << z;
  }
  EXPECT_GT(count({0, 0, 0.75}, test::black), 0) << "the edge is cut, not left out";
  EXPECT_EQ(count({0, 0, 0.25}, test::black), 0);
  view_.setClip({});
  EXPECT_GT(count({0, 0, 4}, test::black), 5);
}

TEST_F(ClipTest, PicksAndFindsOnlyWhatIsInTheBox) {
  clipHeight();
  EXPECT_EQ(view_.pick(pixelOf({0, 0, 1})).node, NodeId{1});
  EXPECT_FALSE(view_.pick(pixelOf({0, 0, 4})).node);
  EXPECT_TRUE(view_.pick(pixelOf({0, 0, 0.75})).edge);
  EXPECT_FALSE(view_.pick(pixelOf({0, 0, 0.25})).edge);
  EXPECT_TRUE(view_.pick(pixelOf({1, 0, 1})).point);
  EXPECT_FALSE(view_.pick(pixelOf({1, 0, 4})).point);
  EXPECT_THAT(view_.nodesInside(everything_, Depth::front),
              testing::ElementsAre(NodeId{1}, NodeId{2}));
  EXPECT_EQ(view_.pointsInside(everything_, Depth::front).size(), 2U);
}

TEST_F(ClipTest, CutsFrustaAndSpheresToo) {
  view_.setShowRadii(true);
  const QImage whole = view_.picture({400, 300});
  clipHeight();
  const QImage cut = view_.picture({400, 300});
  const auto changes = [&](const Eigen::Vector3d& place) {
    const QPoint at = pixelOf(place).toPoint();
    return test::countDifferences(whole.copy(at.x() - 2, at.y() - 2, 5, 5),
                                  cut.copy(at.x() - 2, at.y() - 2, 5, 5)) > 0;
  };
  EXPECT_TRUE(changes({0, 0, 3.5}));
  EXPECT_FALSE(changes({0, 0, 1.5}));
}

// A wall in front of the plant is cut away: what is behind it can be taken.
TEST_F(ClipTest, HidesNothingBehindWhatIsCutAway) {
  view_.setCloud(test::block({0, -3, 2}));
  EXPECT_FALSE(view_.pick(pixelOf({0, 0, 2})).node);
  view_.setClip({.slab = Clip::Slab{0.8, 1}, .box = {}});
  EXPECT_EQ(view_.pick(pixelOf({0, 0, 2})).node, NodeId{2});
}

TEST_F(ClipTest, FadesWhatIsFarther) {
  view_.setCloud(test::cloudOf({{1, -2, 2}, {-1, 2, 2}}));
  EXPECT_GT(count({-1, 2, 2}, test::plain), 5);
  view_.setDepthFade(1);
  EXPECT_GT(count({1, -2, 2}, test::plain), 5);
  EXPECT_EQ(count({-1, 2, 2}, test::plain), 0);
  view_.setDepthFade(0);
  EXPECT_GT(count({-1, 2, 2}, test::plain), 5);
}

} // namespace
} // namespace espalier
