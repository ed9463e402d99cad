#include "core/graph/geodesic.h"
#include "core/graph/geodesic_balls.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace espalier {
namespace {

using Balls = std::vector<std::map<std::uint32_t, float>>; // by center: point -> distance

Balls membersOf(const GeodesicBalls& balls) {
  Balls members(balls.centers().size());
  balls.forEachMember([&](std::size_t center, std::uint32_t point, float distance) {
    EXPECT_TRUE(members[center].emplace(point, distance).second);
  });
  return members;
}

TEST(GeodesicBalls, AreThoseOfDijkstraToTheLastBit) {
  const NeighborhoodGraph graph(test::forkCloud(), 7);
  GeodesicBall one(graph);
  GeodesicBalls many(graph);
  std::vector<std::uint32_t> centers(GeodesicBalls::most);
  GeodesicBalls::Lanes radii;
  for (std::uint32_t first = 0; first + 16 * 31 < graph.size(); first += 200) {
    for (std::uint32_t i = 0; i < 16; ++i) {
      centers[i] = first + i * (first % 31); // near ones, far ones, and the same again and again
      radii[i] = 0.02F * static_cast<float>(i);
    }
    many.find(centers, radii);
    const Balls balls = membersOf(many);
    for (std::uint32_t i = 0; i < 16; ++i) {
      const auto& truth = one.around(centers[i], radii[i]);
      ASSERT_EQ(balls[i].size(), truth.size());
      for (const GeodesicBall::Member& member : truth)
        EXPECT_EQ(balls[i].at(member.point), member.distance);
    }
  }
}

TEST(GeodesicBalls, OfAnyNumberOfCentersAreFound) {
  const NeighborhoodGraph graph(test::forkCloud(), 7);
  GeodesicBalls balls(graph);
  balls.find(std::vector<std::uint32_t>{5, 9}, GeodesicBalls::Lanes::Zero());
  EXPECT_EQ(membersOf(balls), (Balls{{{5, 0.0F}}, {{9, 0.0F}}})); // a radius of 0: the center
  balls.find(std::vector<std::uint32_t>{}, GeodesicBalls::Lanes::Constant(1));
  EXPECT_TRUE(membersOf(balls).empty());
}

TEST(GeodesicBalls, TakeLengthsOfTheirOwnForEachCenter) {
  Eigen::Matrix3Xf line(3, 9);
  for (int i = 0; i < 9; ++i)
    line.col(i) = Eigen::Vector3f(static_cast<float>(i), 0, 0);
  const NeighborhoodGraph graph(line, 2);
  GeodesicBalls balls(graph);
  const auto length = [](std::uint32_t, const NeighborhoodGraph::Link& link) {
    GeodesicBalls::Lanes lengths = GeodesicBalls::Lanes::Constant(link.length);
    lengths[1] *= 2;
    return lengths;
  };
  balls.find(std::vector<std::uint32_t>{4, 4}, GeodesicBalls::Lanes::Constant(2.5F), length);
  EXPECT_EQ(membersOf(balls)[0].size(), 5U);
  EXPECT_EQ(membersOf(balls)[1].size(), 3U);
}

TEST(BallGroups, HoldEachPointOnceWithThoseAroundIt) {
  const NeighborhoodGraph graph(test::forkCloud(), 7);
  const BallGroups groups = ballGroups(graph);
  std::vector<std::uint32_t> points = groups.points;
  std::sort(points.begin(), points.end());
  std::vector<std::uint32_t> all(static_cast<std::size_t>(graph.size()));
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(points, all);
  ASSERT_EQ(groups.ends.back(), all.size());
  EXPECT_LT(groups.ends.size(), all.size() / 8);
  std::size_t first = 0;
  for (const std::size_t end : groups.ends) {
    EXPECT_GT(end, first);
    EXPECT_LE(end - first, 16U);
    first = end;
  }
}

} // namespace
} // namespace espalier
