#include "core/base/parallel.h"
#include "core/graph/neighborhoods.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using Points = std::vector<std::uint32_t>;

/// Points 1 apart up one stick, and down another, 3 away, that meet at the top only.
Eigen::Matrix3Xf arch() {
  Eigen::Matrix3Xf points(3, 24);
  for (int i = 0; i < 11; ++i) {
    points.col(i) = Eigen::Vector3f(0, 0, static_cast<float>(i));
    points.col(13 + i) = Eigen::Vector3f(3, 0, static_cast<float>(10 - i));
  }
  points.col(11) = Eigen::Vector3f(1, 0, 10);
  points.col(12) = Eigen::Vector3f(2, 0, 10);
  return points;
}

Points of(const Neighborhoods& neighborhoods, Eigen::Index point) {
  const auto members = neighborhoods.of(point);
  return {members.begin(), members.end()};
}

TEST(Neighborhoods, OfTheNearestAreSortedByDistance) {
  EXPECT_EQ(of(nearestNeighborhoods(arch(), 3), 0), (Points{1, 2, 3}));
}

TEST(Neighborhoods, HoldAllOthersWhereThereAreFewer) {
  const Eigen::Matrix3Xf three = arch().leftCols(3);
  EXPECT_EQ(of(nearestNeighborhoods(three, 9), 1).size(), 2U);
}

TEST(Neighborhoods, OfCoincidentPointsHoldTheOthers) {
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 5);
  for (Eigen::Index i = 0; i < 5; ++i)
    EXPECT_EQ(of(nearestNeighborhoods(same, 4), i).size(), 4U);
}

TEST(Neighborhoods, AreTheSameOnAnyNumberOfThreads) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Neighborhoods onMany = nearestNeighborhoods(points, 9);
  const ThreadLimit limit(1);
  const Neighborhoods onOne = nearestNeighborhoods(points, 9);
  EXPECT_EQ(onOne.begin, onMany.begin);
  EXPECT_EQ(onOne.members, onMany.members);
}

TEST(Neighborhoods, StopWhenAsked) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  EXPECT_TRUE(
      test::stopsWhenAsked([&](const Progress& p) { (void)nearestNeighborhoods(points, 9, p); }));
}

} // namespace
} // namespace espalier
