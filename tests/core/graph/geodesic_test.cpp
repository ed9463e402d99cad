#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

/// Points 1 apart up one stick, over a bar of 3, and down another.
Eigen::Matrix3Xf archAlong() {
  Eigen::Matrix3Xf points(3, 24);
  for (int i = 0; i < 11; ++i)
    points.col(i) = Eigen::Vector3f(0, 0, static_cast<float>(i));
  for (int i = 0; i < 2; ++i)
    points.col(11 + i) = Eigen::Vector3f(static_cast<float>(i + 1), 0, 10);
  for (int i = 0; i < 11; ++i)
    points.col(13 + i) = Eigen::Vector3f(3, 0, static_cast<float>(10 - i));
  return points;
}

TEST(Geodesics, FollowThePlant) {
  const Geodesics paths = geodesics(NeighborhoodGraph(archAlong(), 2), {0});
  EXPECT_FLOAT_EQ(paths.distance[23], 23); // 3 apart in a straight line
  EXPECT_EQ(paths.predecessor[0], Geodesics::none);
  float length = 0; // of the path back
  for (std::uint32_t at = 23; at != 0; at = paths.predecessor[at])
    length += (archAlong().col(at) - archAlong().col(paths.predecessor[at])).norm();
  EXPECT_FLOAT_EQ(length, 23);
}

TEST(Geodesics, WithAPowerShunLeaps) {
  Eigen::Matrix3Xf points(3, 4); // a leap of 2.5, or three steps of 1
  points << 0, 0, 2.5F, 2.5F, 0, 1, 1, 0, 0, 0, 0, 0;
  const NeighborhoodGraph graph(points, 3);
  EXPECT_EQ(geodesics(graph, {0}, 1).predecessor[3], 0U);
  EXPECT_FLOAT_EQ(geodesics(graph, {0}, 1).distance[3], 2.5F);
  EXPECT_FLOAT_EQ(geodesics(graph, {0}, 2).distance[3], 6.25F);
}

TEST(Geodesics, AreInfiniteWhereNoPathLeads) {
  const Eigen::Matrix3Xf far = archAlong().colwise() + Eigen::Vector3f(100, 0, 0);
  const Geodesics paths = geodesics(NeighborhoodGraph(test::both(archAlong(), far), 2), {0});
  EXPECT_TRUE(std::isinf(paths.distance[30]));
}

TEST(GeodesicBall, HoldsWhatIsWithinReachAlongThePlant) {
  const NeighborhoodGraph graph(archAlong(), 2);
  GeodesicBall ball(graph);
  const auto& members = ball.around(0, 4.5F);
  ASSERT_EQ(members.size(), 5U);
  for (std::uint32_t i = 0; i < 5; ++i)
    EXPECT_EQ(members[i].point, i);
}

TEST(GeodesicBall, AgreesWithThePathsFromItsCenter) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const NeighborhoodGraph graph(points, 7);
  GeodesicBall ball(graph);
  for (Eigen::Index center = 0; center < points.cols(); center += 97) {
    const Geodesics paths = geodesics(graph, {center});
    const auto& members = ball.around(center, 0.3F);
    const auto within = std::count_if(paths.distance.begin(), paths.distance.end(),
                                      [](float d) { return d <= 0.3F; });
    EXPECT_EQ(static_cast<std::ptrdiff_t>(members.size()), within);
    for (const GeodesicBall::Member& member : members)
      EXPECT_FLOAT_EQ(member.distance, paths.distance[member.point]);
  }
}

} // namespace
} // namespace espalier
