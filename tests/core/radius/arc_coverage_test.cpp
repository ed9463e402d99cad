#include "core/base/error.h"
#include "core/radius/arc_coverage.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stop_token>
#include <vector>

namespace espalier {
namespace {

/// Points at the distance 1 from the z axis, in the middle of each of the first sectors of 16, from
/// z = -1 to 11, 0.1 apart.
Eigen::Matrix3Xf shell(int sectors) {
  constexpr int layers = 121;
  Eigen::Matrix3Xf points(3, layers * sectors);
  for (int layer = 0; layer < layers; ++layer)
    for (int k = 0; k < sectors; ++k) {
      const double angle = (k + 0.5) * 2 * std::numbers::pi / 16;
      points.col(layer * sectors + k) =
          Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.1 * layer - 1).cast<float>();
    }
  return points;
}

Skeleton thickStick() {
  Skeleton plant = test::stick(11);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 1);
  return plant;
}

std::vector<double> coverages(const Skeleton& plant, const Eigen::Matrix3Xf& points,
                              const Progress& progress = {}) {
  const SpatialIndex index(points);
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  return arcCoverages(plant, {points, origin, index, 0.1}, progress);
}

TEST(ArcCoverages, AreTheSharesOfTheArcThatHavePoints) {
  for (const int sectors : {1, 4, 7, 16}) {
    const std::vector<double> seen = coverages(thickStick(), shell(sectors));
    ASSERT_EQ(seen.size(), 11U);
    for (const double share : seen)
      EXPECT_EQ(share, sectors / 16.0);
  }
}

TEST(ArcCoverages, AreZeroWithoutPointsOrDirection) {
  for (const double share : coverages(thickStick(), Eigen::Matrix3Xf(3, 0)))
    EXPECT_EQ(share, 0);
  EXPECT_EQ(coverages(test::stick(1), shell(16)), std::vector<double>{0});
  Skeleton plant = thickStick();
  plant.erase(NodeId{10});
  EXPECT_EQ(coverages(plant, shell(16)).back(), 0) << "no node has this id";
}

TEST(ArcCoverages, StopWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(coverages(thickStick(), shell(4), Progress(stop.get_token(), {}))),
               Cancelled);
}

} // namespace
} // namespace espalier
