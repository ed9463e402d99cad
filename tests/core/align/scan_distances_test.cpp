#include "core/align/scan_distances.h"
#include "core/base/error.h"
#include "tests/support/cloud_of.h"

#include <gtest/gtest.h>

#include <stop_token>

namespace espalier {
namespace {

/// Points at whole numbers of a line.
Eigen::Matrix3Xf line(Eigen::Index count) {
  Eigen::Matrix3Xf points = Eigen::Matrix3Xf::Zero(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    points(0, i) = static_cast<float>(i);
  return points;
}

TEST(ScanDistances, AreThoseOfThePointsWhereTheyWereMoved) {
  const auto fixed = test::cloudOf(line(50));
  const auto moved = test::cloudAtOrigin(line(50));
  const SpatialIndex index(fixed->positions());
  const Eigen::Isometry3d motion(Eigen::Translation3d(500, 600.25, 700));
  for (const float distance : distancesToScan(*moved, motion, *fixed, index))
    EXPECT_NEAR(distance, 0.25, 1e-4);
}

TEST(ScanDistances, PassOverPointsThatAreSetAside) {
  const auto fixed = test::cloudAtOrigin(line(2));
  const auto moved = test::cloudAtOrigin(line(1));
  const Eigen::Index nearest = fixed->position(0).x() < 0.5 ? 0 : 1;
  const SpatialIndex index = SpatialIndex(fixed->positions()).passingOver([&] {
    std::vector<bool> passed(2, false);
    passed[static_cast<std::size_t>(nearest)] = true;
    return passed;
  }());
  EXPECT_NEAR(distancesToScan(*moved, Eigen::Isometry3d::Identity(), *fixed, index)[0], 1, 1e-6);
}

TEST(ScanDistances, CanBeStopped) {
  const auto cloud = test::cloudAtOrigin(line(50));
  const SpatialIndex index(cloud->positions());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)distancesToScan(*cloud, Eigen::Isometry3d::Identity(), *cloud, index,
                                     Progress(stop.get_token(), [](double, std::string_view) {})),
               Cancelled);
}

} // namespace
} // namespace espalier
