#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/still_so.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// From straight up it turns by the angle given.
Skeleton turning(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  Skeleton plant = test::stick(3);
  plant.add(
      {.position = {std::sin(angle), 0, 2 + std::cos(angle)}, .radius = 0.1, .parent = NodeId{2}});
  return plant;
}

std::vector<Finding> stillTurns(double degrees) {
  const std::vector<Finding> reported = check(turning(120));
  EXPECT_THAT(reported, SizeIs(1));
  const Skeleton now = turning(degrees);
  return stillSo(reported, check(now), check(now, 0, atSensitivity({.sensitivity = 2})), nullptr);
}

TEST(StillSo, IsATurnThatWasHardlyLessened) {
  EXPECT_THAT(stillTurns(110), IsEmpty()) << "it is found as before";
  ASSERT_THAT(stillTurns(85), SizeIs(1)) << "under the limit of 90 degrees, and over half of 120";
  EXPECT_NEAR(stillTurns(85)[0].amount, 85 * std::numbers::pi / 180, 1e-9);
  EXPECT_THAT(stillTurns(55), IsEmpty());
}

/// A trunk with 8 points in a row to its right, and a branch over the first `made` of them.
struct Twig {
  Skeleton plant = test::stick(3);
  std::shared_ptr<const PointCloud> cloud;
  explicit Twig(int made) {
    Eigen::Matrix3Xf row(3, 8);
    for (int i = 0; i < 8; ++i)
      row.col(i) << 0.18F + 0.02F * static_cast<float>(i), 0, 1;
    cloud = test::cloudAtOrigin(test::both(
        test::cylinder(Eigen::Vector3d::Zero(), Eigen::Vector3d(0, 0, 2), 0.1, 0.02), row));
    if (made > 0)
      plant.add({.position = {0.16 + 0.02 * made - 0.045, 0, 1},
                 .radius = 0.005,
                 .parent = NodeId{1},
                 .edge = EdgeType::branching});
  }
};

std::vector<Finding> stillBare(int made) {
  constexpr double spacing = 0.013;
  const CheckOptions limits;
  const Twig bare(0);
  const std::vector<Finding> reported =
      unexplainedClusters(PointDistances(bare.cloud, spacing, bare.plant), spacing, limits);
  EXPECT_THAT(reported, SizeIs(1));
  const Twig twig(made);
  const PointDistances distances(twig.cloud, spacing, twig.plant);
  const PointsNow points{.skeleton = twig.plant,
                         .distances = distances,
                         .spacing = spacing,
                         .reach = limits.pointReach * exactness(distances, spacing, limits)};
  return stillSo(reported, unexplainedClusters(distances, spacing, limits), {}, &points);
}

TEST(StillSo, IsATwigUntilHalfOfItsPointsHaveWood) {
  ASSERT_THAT(stillBare(4), SizeIs(1)) << "5 points are too few to be reported alone";
  EXPECT_EQ(stillBare(4)[0].amount, 5);
  EXPECT_THAT(stillBare(4)[0].points, SizeIs(5));
  EXPECT_THAT(stillBare(6), IsEmpty());
}

/// Points in a sheet beside a stem, and where they were found: on an axis amid them, or at the
/// stem.
struct BladeBeside {
  static constexpr double spacing = 0.01;
  Skeleton plant = test::stick(2);
  std::shared_ptr<const PointCloud> cloud;
  BladeBeside() {
    Eigen::Matrix3Xf sheet(3, 61 * 31);
    for (int i = 0; i <= 60; ++i)
      for (int k = 0; k <= 30; ++k)
        sheet.col(31 * i + k) << 0.3F + 0.01F * static_cast<float>(i),
            -0.15F + 0.01F * static_cast<float>(k), 0.5F;
    cloud = test::cloudAtOrigin(sheet);
  }
  [[nodiscard]] std::vector<Finding> still(const std::vector<Finding>& reported) const {
    const PointDistances distances(cloud, spacing, plant);
    const PointsNow points{plant, distances, spacing, 3 * spacing};
    return stillSo(reported, {}, {}, &points);
  }
};

TEST(StillSo, IsNoBladeThatHasItsAxis) {
  BladeBeside blade;
  const std::vector<Finding> reported = unexplainedClusters(
      PointDistances(blade.cloud, BladeBeside::spacing, blade.plant), BladeBeside::spacing, {});
  ASSERT_THAT(reported, SizeIs(1));
  EXPECT_THAT(blade.still(reported), SizeIs(1));
  EXPECT_THAT(blade.still({reported[0], reported[0]}), SizeIs(1)) << "one row for the same points";
  std::optional<NodeId> last = NodeId{0};
  for (int i = 0; i <= 6; ++i)
    last = blade.plant.add({.position = {0.3 + 0.1 * i, 0, 0.5}, .radius = 0.01, .parent = last});
  EXPECT_THAT(blade.still(reported), IsEmpty());
}

TEST(StillSo, IsNothingOfPointsThatAreMeasuredAnew) {
  const Finding twig{.kind = Finding::Kind::unexplainedPoints, .node = NodeId{1}, .points = {1, 2}};
  EXPECT_THAT(stillSo({twig}, {}, {}, nullptr), IsEmpty());
}

} // namespace
} // namespace espalier
