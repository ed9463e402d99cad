#include "core/base/random.h"
#include "core/cloud/point_cloud.h"
#include "ui/view/point_hierarchy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace espalier {
namespace {

PointCloud blob(int count) {
  Random random(7);
  RawPoints raw;
  for (int i = 0; i < count; ++i)
    raw.positions.emplace_back(random.normal(), random.normal(), random.normal());
  return PointCloud(std::move(raw));
}

/// From (x, -10, z) along y.
ViewCone lookAlongY(float x, float z, float radius, float slope = 0) {
  return {{x, -10, z}, Eigen::Vector3f::UnitY(), radius, slope};
}

bool contains(const ViewCone& cone, const Eigen::Vector3f& point) {
  const Eigen::Vector3f offset = point - cone.apex;
  const float depth = offset.dot(cone.direction);
  return depth > 0 && (offset - depth * cone.direction).norm() <= cone.radius + cone.slope * depth;
}

TEST(PointHierarchy, FindsAPointOfTheConeWhereverThereIsOne) {
  const PointCloud cloud = blob(5000);
  const PointHierarchy boxes(cloud.positions());
  Random random(3);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const ViewCone cone = lookAlongY(static_cast<float>(random.uniform(-3, 3)),
                                     static_cast<float>(random.uniform(-3, 3)), 0.01F, 0.002F);
    bool any = false;
    for (Eigen::Index p = 0; p < cloud.size(); ++p)
      any = any || contains(cone, cloud.positions().col(p));
    const auto pick = boxes.pick(cloud.positions(), cone);
    ASSERT_EQ(pick.has_value(), any);
    ASSERT_TRUE(!pick || contains(cone, cloud.positions().col(*pick)));
    found += any ? 1 : 0;
  }
  EXPECT_GT(found, 50);
  EXPECT_LT(found, 250);
}

TEST(PointHierarchy, TakesThePointInFront) {
  Eigen::Matrix3Xf points(3, 3);
  points.col(0) << 0, 2, 0;
  points.col(1) << 0, -1, 0;
  points.col(2) << 0, 5, 0;
  EXPECT_EQ(PointHierarchy(points).pick(points, lookAlongY(0, 0, 0.1F)), 1);
}

TEST(PointHierarchy, TakesThePointNearTheAxisOfTwoAboutEquallyDeep) {
  Eigen::Matrix3Xf points(3, 2);
  points.col(0) << 0.09F, 0, 0;
  points.col(1) << 0.01F, 0.05F, 0;
  EXPECT_EQ(PointHierarchy(points).pick(points, lookAlongY(0, 0, 0.1F)), 1);
}

TEST(PointHierarchy, IsEmptyWithoutPoints) {
  const Eigen::Matrix3Xf none(3, 0);
  const PointHierarchy boxes(none);
  EXPECT_FALSE(boxes.pick(none, lookAlongY(0, 0, 1)));
  EXPECT_TRUE(boxes.bounds().isEmpty());
}

TEST(PointHierarchy, EnclosesAllPoints) {
  const PointCloud cloud = blob(1000);
  const Eigen::AlignedBox3f box = PointHierarchy(cloud.positions()).bounds();
  EXPECT_TRUE(box.min().isApprox(cloud.positions().rowwise().minCoeff()));
  EXPECT_TRUE(box.max().isApprox(cloud.positions().rowwise().maxCoeff()));
}

TEST(PointHierarchy, ReturnsTheDistanceToTheNearestPoint) {
  const PointCloud cloud = blob(3000);
  const PointHierarchy boxes(cloud.positions());
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3f place =
        Eigen::Vector3d(random.normal(), random.normal(), 2).cast<float>();
    const float nearest = (cloud.positions().colwise() - place).colwise().norm().minCoeff();
    EXPECT_FLOAT_EQ(boxes.distance(cloud.positions(), place), nearest);
  }
  EXPECT_EQ(boxes.distance(cloud.positions(), cloud.positions().col(7)), 0);
  EXPECT_GT(boxes.distance(cloud.positions(), cloud.positions().col(7), 0), 0);
  EXPECT_TRUE(std::isinf(PointHierarchy().distance({}, {0, 0, 0})));
}

TEST(PointHierarchy, VisitsEachRunThatMayMeetInOrder) {
  const PointCloud cloud = blob(1000);
  const PointHierarchy boxes(cloud.positions());
  Eigen::Index next = 0;
  boxes.forEachRun([](const Eigen::AlignedBox3f&) { return true; },
                   [&](Eigen::Index begin, Eigen::Index end) {
                     EXPECT_EQ(begin, next);
                     next = end;
                   });
  EXPECT_EQ(next, cloud.size());
  Eigen::Index above = 0; // points that are, all visited
  boxes.forEachRun([](const Eigen::AlignedBox3f& box) { return box.max().z() > 1; },
                   [&](Eigen::Index begin, Eigen::Index end) {
                     for (Eigen::Index i = begin; i < end; ++i)
                       above += cloud.positions()(2, i) > 1 ? 1 : 0;
                   });
  EXPECT_EQ(above, (cloud.positions().row(2).array() > 1).count());
}

} // namespace
} // namespace espalier
