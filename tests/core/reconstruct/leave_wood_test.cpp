#include "core/reconstruct/centered_line.h"
#include "core/reconstruct/leave_wood.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A trunk upright from the origin, 2 long and 0.1 thick, with a node each 0.25, of which the scan
/// shows a twig at 1.2, 1 long and 0.03 thick, which rises by 45 degrees.
class LeavesATrunk : public testing::Test {
protected:
  static constexpr double spacing = 0.02;
  const Vector3d foot_{0, 0, 1.2};
  const Vector3d along_ = Vector3d(1, 0, 1).normalized();

  LeavesATrunk() {
    std::optional<NodeId> last;
    for (int i = 0; i <= 8; ++i)
      last = trunk_.add({.position = {0, 0, 0.25 * i}, .radius = 0.1, .parent = last});
    wood_ = std::make_shared<const EdgeIndex>(bodiesOf(trunk_));
    const Eigen::Matrix3Xf points =
        test::both(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, spacing),
                   test::cylinder(foot_ + 0.15 * along_, foot_ + along_, 0.03, spacing));
    RawPoints raw;
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      raw.positions.emplace_back(points.col(i).cast<double>());
    cloud_ = std::make_shared<const PointCloud>(std::move(raw));
  }

  [[nodiscard]] Trace tracedFrom(double height) const {
    return TraceGraph(cloud_)
        .between({{0, 0, height}, true}, {foot_ + along_, false},
                 {.step = 0.2, .alternatives = 0, .wood = wood_})
        .front();
  }

  Skeleton trunk_;
  std::shared_ptr<const EdgeIndex> wood_;
  std::shared_ptr<const PointCloud> cloud_;
};

TEST_F(LeavesATrunk, WhereItsPointsDoWhereverOnItTheTraceIsStarted) {
  for (const double height : {0.5, 1.0, 1.25, 1.75}) {
    const Trace trace = tracedFrom(height);
    ASSERT_TRUE(trace.begin) << height;
    EXPECT_NEAR(trace.places.front().z(), 1.2, 0.1) << "within the radius of the trunk: " << height;
    EXPECT_LT(trace.places.front().head<2>().norm(), 1e-9) << "on the axis";
    for (std::size_t i = 1; i < trace.places.size(); ++i) {
      EXPECT_GT(trace.places[i].head<2>().norm(), 0.1) << "none in the trunk";
      EXPECT_LT(distanceToLine(trace.places[i], {foot_, foot_ + 1.1 * along_}), 0.03);
    }
  }
}

TEST_F(LeavesATrunk, AtANewNodeOfItsEdge) {
  const Trace trace = tracedFrom(0.5);
  SkeletonEditor editor(trunk_);
  const NodeId last = addTrace(editor, trace);
  (void)editor.commit();
  EXPECT_EQ(trunk_.roots().size(), 1U);
  EXPECT_EQ(trunk_.size(), 9 + trace.places.size());
  NodeId first = last;
  while (trunk_[first].edge == EdgeType::successor)
    first = *trunk_[first].parent;
  EXPECT_EQ(trunk_[*trunk_[first].parent].position, trace.places.front());
}

TEST_F(LeavesATrunk, NotAtAllIfItEndsOnIt) {
  const Trace trace = TraceGraph(cloud_)
                          .between({{0, 0, 0.5}, true}, {{0.1, 0, 0.9}, false},
                                   {.step = 0.2, .alternatives = 0, .wood = wood_})
                          .front();
  ASSERT_TRUE(trace.begin);
  EXPECT_EQ(trace.places.front(), Vector3d(0, 0, 0.5));
}

TEST(Leaving, IsNowhereForPlacesThatBeginInTheAir) {
  Skeleton stick;
  const NodeId root = stick.add({.position = {0, 0, 0}, .radius = 0.1});
  stick.add({.position = {0, 0, 1}, .radius = 0.1, .parent = root});
  const EdgeIndex wood(bodiesOf(stick));
  EXPECT_FALSE(leavingWood({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, wood, 0.1));
  const auto leaving =
      leavingWood({{0, 0, 0.5}, {0.1, 0, 0.5}, {0.3, 0, 0.5}, {0.8, 0, 0.5}}, wood, 0.1);
  ASSERT_TRUE(leaving);
  EXPECT_EQ(leaving->first, 2U);
  EXPECT_NEAR(leaving->place.z(), 0.5, 1e-9);
}

TEST(Leaving, IsAtANodeWithinTwoSpacings) {
  Skeleton stick;
  const NodeId root = stick.add({.position = {0, 0, 0}, .radius = 0.1});
  const NodeId node = stick.add({.position = {0, 0, 1}, .radius = 0.1, .parent = root});
  stick.add({.position = {0, 0, 2}, .radius = 0.1, .parent = node});
  const EdgeIndex wood(bodiesOf(stick));
  const auto leaving =
      leavingWood({{0, 0, 0.8}, {0.1, 0, 0.9}, {0.3, 0, 0.9}, {0.8, 0, 0.9}}, wood, 0.1);
  ASSERT_TRUE(leaving);
  EXPECT_EQ(leaving->place, Eigen::Vector3d(0, 0, 1)) << "another would make a short edge";
}

// Of a fork in thick wood that begins in its middle, the thick wood bears what leaves its bark.
TEST(Leaving, IsFromTheThickWoodAndNotFromATwigThatBeginsInIt) {
  Skeleton trunk;
  const NodeId root = trunk.add({.position = {0, 0, 0}, .radius = 0.5});
  const NodeId top = trunk.add({.position = {0, 0, 4}, .radius = 0.5, .parent = root});
  trunk.add({.position = {0, 0, 8}, .radius = 0.5, .parent = top});
  trunk.add(
      {.position = {0.55, 0.3, 4}, .radius = 0.02, .parent = top, .edge = EdgeType::branching});
  const EdgeIndex wood(bodiesOf(trunk));
  const auto leaving =
      leavingWood({{0, 0, 4.4}, {0.5, 0.2, 4.4}, {0.7, 0.2, 4.4}, {1.5, 0.2, 4.4}}, wood, 0.05);
  ASSERT_TRUE(leaving);
  EXPECT_NEAR(leaving->place.z(), 4.4, 0.15);
  EXPECT_LT(leaving->place.head<2>().norm(), 1e-9);
}

} // namespace
} // namespace espalier
