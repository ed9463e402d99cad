#include "core/radius/measured_radius.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
constexpr double spacing = 0.02;

std::vector<MeasuredRadius> measured(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                                     const Progress& progress = {}) {
  const AssignedPoints assigned(skeleton, points, zero);
  return cylinderRadii(skeleton, assigned, {.spacing = spacing}, progress);
}

TEST(CylinderRadii, OfACylinderAreItsRadiusWhereverTheSkeletonRunsInIt) {
  Skeleton stick = test::stick(9, 0.25);
  for (const NodeId id : stick.ids()) // towards one side
    stick.setPosition(id, stick[id].position + Eigen::Vector3d(0.06, 0.02, 0));
  const auto radii = measured(stick, test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, spacing));
  for (const MeasuredRadius& each : radii) {
    EXPECT_NEAR(each.radius, 0.1, 0.001);
    EXPECT_GE(each.deviation, 0.04);
    EXPECT_LT(each.deviation, 0.1);
  }
}

TEST(CylinderRadii, AreNotPulledInByAOneSidedScan) {
  Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, spacing);
  points.row(0) = points.row(0).cwiseAbs();
  Skeleton stick = test::stick(9, 0.25);
  for (const NodeId id : stick.ids()) // at the mean of the half circle
    stick.setPosition(id, stick[id].position + Eigen::Vector3d(0.0637, 0, 0));
  for (const MeasuredRadius& each : measured(stick, points))
    EXPECT_NEAR(each.radius, 0.1, 0.005);
}

TEST(CylinderRadii, AreNoneWhereThereAreNoPoints) {
  const Skeleton stick = test::stick(9, 0.25);
  const auto radii = measured(stick, test::cylinder({0, 0, 0}, {0, 0, 0.5}, 0.1, spacing));
  EXPECT_GT(radii[0].radius, 0);
  EXPECT_EQ(radii[8].radius, 0);
  EXPECT_TRUE(measured({}, Eigen::Matrix3Xf(3, 0)).empty());
  EXPECT_EQ(measured(test::stick(1), Eigen::Matrix3Xf(3, 0))[0].radius, 0);
}

TEST(CylinderRadii, AreNotFoundOnceToldToStop) {
  const Skeleton stick = test::stick(9, 0.25);
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, spacing);
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)measured(stick, points, progress); }));
}

TEST(ThinRadii, AreMeanDistancesWhereThereIsNoCylinder) {
  const Skeleton stick = test::stick(3);
  Eigen::Matrix3Xf points(3, 4);
  points << 0.02F, -0.04F, 0, 0, 0, 0, 0.06F, -0.08F, 2, 2, 2, 2;
  const AssignedPoints assigned(stick, points, zero);
  const MeasuredRadius known{.radius = 0.2, .deviation = 0.05};
  const auto radii = withThinRadii(stick, assigned, {known, {}, {}});
  EXPECT_EQ(radii[0].radius, 0.2) << "what is known stays";
  EXPECT_EQ(radii[0].deviation, 0.05);
  EXPECT_EQ(radii[1].radius, 0) << "it has no points";
  EXPECT_NEAR(radii[2].radius, 0.05, 1e-6);
  EXPECT_GT(radii[2].deviation, known.deviation);
}

} // namespace
} // namespace espalier
