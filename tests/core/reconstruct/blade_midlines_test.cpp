#include "core/reconstruct/blade_midlines.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

constexpr double gridStep = 0.01;
constexpr MidlineOptions midlineOptions{.link = 3, .step = 5, .leastLength = 0.1, .widestGap = 0.1};

/// An upright stem of length 1 above the origin.
Skeleton stemOfNodes() {
  Skeleton stem;
  NodeId below = stem.add({});
  for (int i = 1; i <= 10; ++i)
    below = stem.add({.position = {0, 0, 0.1 * i}, .radius = 0.01, .parent = below});
  return stem;
}

/// The place on the middle of a blade that droops along a quarter of a circle.
Eigen::Vector3d onMidrib(double azimuth, double z, double along) {
  constexpr double bend = 0.4; // radius of the circle
  const double out = 0.02 + bend * std::sin(along / bend);
  return {out * std::cos(azimuth), out * std::sin(azimuth),
          z - bend * (1 - std::cos(along / bend))};
}

/// Points of a blade as long and as wide at half of its length as asked, narrow at both ends.
Eigen::Matrix3Xd bladeOfPoints(double azimuth, double z, double length, double width) {
  const Eigen::Vector3d across(-std::sin(azimuth), std::cos(azimuth), 0);
  Eigen::Matrix3Xd points(3, 0);
  for (double along = 0; along <= length; along += gridStep) {
    const double half = gridStep + width / 2 * std::sin(along / length * std::numbers::pi);
    for (double side = -half; side <= half; side += gridStep) {
      points.conservativeResize(3, points.cols() + 1);
      points.col(points.cols() - 1) = onMidrib(azimuth, z, along) + side * across;
    }
  }
  return points;
}

Eigen::Matrix3Xd bothBlades(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  Eigen::Matrix3Xd points(3, a.cols() + b.cols());
  points << a, b;
  return points;
}

std::vector<NodeId> addedNodes(const Skeleton& skeleton) {
  std::vector<NodeId> added;
  for (const NodeId id : skeleton.ids())
    if (indexOf(id) >= stemOfNodes().size()) added.push_back(id);
  return added;
}

TEST(BladeMidlines, LeadFromTheWoodToTheTipAlongTheMiddle) {
  const Skeleton skeleton =
      withMidlines(stemOfNodes(), bladeOfPoints(0.7, 0.5, 0.5, 0.12), midlineOptions);
  const std::vector<NodeId> added = addedNodes(skeleton);
  ASSERT_EQ(added.size(), 10U); // 0.5 long, by steps of 0.05
  const Node& first = skeleton[added.front()];
  EXPECT_EQ(first.edge, EdgeType::branching);
  EXPECT_NEAR(skeleton[*first.parent].position.z(), 0.5, 0.01);
  for (const NodeId id : added) {
    double off = 1;
    for (double along = 0; along <= 0.5; along += 0.002)
      off = std::min(off, (onMidrib(0.7, 0.5, along) - skeleton[id].position).norm());
    EXPECT_LT(off, 0.015) << indexOf(id);
    EXPECT_LE(skeleton.children(id).size(), 1U);
  }
  EXPECT_LT((skeleton[added.back()].position - onMidrib(0.7, 0.5, 0.5)).norm(), 0.02);
}

TEST(BladeMidlines, AreOnePerBlade) {
  const Eigen::Matrix3Xd two =
      bothBlades(bladeOfPoints(0, 0.5, 0.4, 0.1), bladeOfPoints(2.5, 0.8, 0.3, 0.1));
  const Skeleton skeleton = withMidlines(stemOfNodes(), two, midlineOptions);
  EXPECT_EQ(skeleton.children(NodeId{5}).size(), 2U);
  EXPECT_EQ(skeleton.children(NodeId{8}).size(), 2U);
  EXPECT_EQ(test::countTips(skeleton), 3);
}

TEST(BladeMidlines, LeaveOutScrapsAndWhatIsFarFromTheWood) {
  const Skeleton stem = stemOfNodes();
  EXPECT_EQ(withMidlines(stem, bladeOfPoints(0, 0.5, 0.06, 0.05), midlineOptions), stem);
  Eigen::Matrix3Xd far = bladeOfPoints(0, 0.5, 0.4, 0.1);
  far.colwise() += Eigen::Vector3d(3, 0, 0);
  EXPECT_EQ(withMidlines(stem, far, midlineOptions), stem);
}

TEST(BladeMidlines, OfNothingAreNone) {
  const Skeleton stem = stemOfNodes();
  EXPECT_EQ(withMidlines(stem, Eigen::Matrix3Xd(3, 0), midlineOptions), stem);
  EXPECT_EQ(withMidlines(stem, Eigen::Matrix3Xd::Constant(3, 50, 0.1), midlineOptions), stem);
  EXPECT_TRUE(withMidlines({}, bladeOfPoints(0, 0.5, 0.4, 0.1), midlineOptions).isEmpty());
}

TEST(BladeMidlines, StopWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)withMidlines(stemOfNodes(), bladeOfPoints(0, 0.5, 0.4, 0.1), midlineOptions, progress);
  }));
}

} // namespace
} // namespace espalier
