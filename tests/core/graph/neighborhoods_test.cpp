#include "core/base/parallel.h"
#include "core/graph/neighborhoods.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <limits>

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

TEST(Neighborhoods, InSpaceLeapFromStickToStick) {
  // Those 3 away come in the order of their numbers, then the one at sqrt(10).
  EXPECT_EQ(of(neighborhoodsWithin(arch(), 3.2F), 0), (Points{1, 2, 3, 23, 22}));
}

TEST(Neighborhoods, AlongTheGraphStayOnTheirStick) {
  const NeighborhoodGraph graph(arch(), 2);
  EXPECT_EQ(of(geodesicWithin(graph, 3.1F), 0), (Points{1, 2, 3}));
  EXPECT_EQ(of(geodesicNearest(graph, 4), 0), (Points{1, 2, 3, 4}));
  EXPECT_EQ(of(geodesicNearest(graph, 12), 0).back(), 12U); // over the bar
}

TEST(Neighborhoods, OfTheNearestAreSortedByDistance) {
  EXPECT_EQ(of(nearestNeighborhoods(arch(), 3), 0), (Points{1, 2, 3}));
}

TEST(Neighborhoods, HoldAllOthersWhereThereAreFewer) {
  const Eigen::Matrix3Xf three = arch().leftCols(3);
  const NeighborhoodGraph graph(three, 7);
  EXPECT_EQ(of(nearestNeighborhoods(three, 9), 1).size(), 2U);
  EXPECT_EQ(of(geodesicNearest(graph, 9), 1).size(), 2U);
  EXPECT_EQ(of(geodesicWithin(graph, 100), 1).size(), 2U);
  EXPECT_EQ(of(neighborhoodsWithin(three, 100), 1).size(), 2U);
}

TEST(Neighborhoods, OfCoincidentPointsHoldTheOthers) {
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 5);
  const NeighborhoodGraph graph(same, 4);
  for (Eigen::Index i = 0; i < 5; ++i) {
    EXPECT_EQ(of(neighborhoodsWithin(same, 0.1F), i).size(), 4U);
    EXPECT_EQ(of(geodesicWithin(graph, 0), i).size(), 4U);
    EXPECT_EQ(of(geodesicNearest(graph, 2), i).size(), 2U);
  }
}

// More points than are searched before their lists are put together.
TEST(Neighborhoods, AlongAGraphAreThoseOfEachPointWhereThereAreMany) {
  Eigen::Matrix3Xf line = Eigen::Matrix3Xf::Zero(3, 40'000);
  line.row(0) = Eigen::RowVectorXf::LinSpaced(line.cols(), 0, static_cast<float>(line.cols() - 1));
  const Neighborhoods near = geodesicWithin(NeighborhoodGraph(line, 2), 2.1F);
  ASSERT_EQ(near.size(), 40'000U);
  for (Eigen::Index i = 2; i + 2 < line.cols(); ++i) {
    const auto at = static_cast<std::uint32_t>(i);
    ASSERT_EQ(of(near, i), (Points{at - 1, at + 1, at - 2, at + 2})) << i;
  }
}

TEST(Neighborhoods, AreTheSameOnAnyNumberOfThreads) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const NeighborhoodGraph graph(points, 7);
  const Neighborhoods onMany = geodesicWithin(graph, 0.1F);
  const ThreadLimit limit(1);
  const Neighborhoods onOne = geodesicWithin(graph, 0.1F);
  EXPECT_EQ(onOne.begin, onMany.begin);
  EXPECT_EQ(onOne.members, onMany.members);
}

TEST(Neighborhoods, StopWhenAsked) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const NeighborhoodGraph graph(points, 7);
  using test::stopsWhenAsked;
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { (void)geodesicWithin(graph, 1, p); }));
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { (void)geodesicNearest(graph, 9, p); }));
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { (void)neighborhoodsWithin(points, 1, p); }));
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { (void)nearestNeighborhoods(points, 9, p); }));
}

} // namespace
} // namespace espalier
