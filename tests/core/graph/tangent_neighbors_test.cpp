#include "core/graph/tangent_neighbors.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace espalier {
namespace {

/// The origin, four places about it at 1, and those at the corners between them, farther off.
Eigen::Matrix3Xf cross() {
  Eigen::Matrix3Xf points(3, 9);
  points << 0, 1, 0, -1, 0, 1.5F, -1.5F, -1.5F, 1.5F, //
      0, 0, 1, 0, -1, 1.5F, 1.5F, -1.5F, -1.5F,       //
      0, 0, 0, 0, 0, 0, 0, 0, 0;
  return points;
}

Eigen::Matrix3Xf up(const Eigen::Matrix3Xf& points) {
  return Eigen::Vector3f::UnitZ().replicate(1, points.cols());
}

std::vector<std::uint32_t> membersOf(const Neighborhoods& neighborhoods, Eigen::Index point) {
  const auto members = neighborhoods.of(point);
  return {members.begin(), members.end()};
}

TEST(VoronoiRing, HoldsThoseWhoseCellsTouch) {
  const std::vector<std::uint32_t> all = {1, 2, 3, 4, 5, 6, 7, 8};
  const auto ring = voronoiRing(cross(), 0, Eigen::Vector3f::UnitZ(), all);
  ASSERT_EQ(ring.size(), 4U); // the cell is a square, beyond whose corners the others lie
  EXPECT_EQ(std::set<std::uint32_t>(ring.begin(), ring.end()),
            (std::set<std::uint32_t>{1, 2, 3, 4}));
  for (std::size_t i = 0; i < 4; ++i) // each next to the one a quarter turn on
    EXPECT_EQ(cross().col(ring[i]).dot(cross().col(ring[(i + 1) % 4])), 0);
}

TEST(VoronoiRing, ShowsWhereTheSurfaceEnds) {
  const std::vector<std::uint32_t> half = {1, 2, 4}; // none at -x
  const auto ring = voronoiRing(cross(), 0, Eigen::Vector3f::UnitZ(), half);
  EXPECT_EQ(ring.size(), 4U);
  EXPECT_EQ(std::ranges::count(ring, noNeighbor), 1);
}

TEST(VoronoiRing, OfCoincidentPointsIsEmpty) {
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 4);
  EXPECT_TRUE(
      voronoiRing(same, 0, Eigen::Vector3f::UnitZ(), std::vector<std::uint32_t>{1, 2, 3}).empty());
}

/// Lines membersOf points 0.1 apart that a scanner drew 1 apart: the 8 nearest lie on one line.
Eigen::Matrix3Xf scanLines() {
  Eigen::Matrix3Xf points(3, 5 * 41);
  for (int line = 0; line < 5; ++line)
    for (int i = 0; i < 41; ++i)
      points.col(41 * line + i) =
          Eigen::Vector3f(0.1F * static_cast<float>(i), static_cast<float>(line), 0);
  return points;
}

constexpr Eigen::Index middleOfTwoRows = 41 * 2 + 20;

TEST(VoronoiNeighbors, SurroundAPointOfAScanLine) {
  const Eigen::Matrix3Xf points = scanLines();
  const auto found = membersOf(
      voronoiNeighbors(points, up(points), nearestNeighborhoods(points, 40)), middleOfTwoRows);
  std::set<float> lines;
  for (const std::uint32_t other : found)
    lines.insert(points(1, other));
  EXPECT_EQ(lines, (std::set<float>{1, 2, 3}));
}

TEST(AngleCriterion, ReachesOverToTheNextScanLines) {
  const Eigen::Matrix3Xf points = scanLines();
  const auto near = nearestNeighborhoods(points, 40);
  const auto found =
      membersOf(angleCriterionNeighbors(points, up(points), near, 8), middleOfTwoRows);
  EXPECT_EQ(found.size(), 8U);
  std::set<float> lines;
  for (const std::uint32_t other : found)
    lines.insert(points(1, other));
  EXPECT_EQ(lines, (std::set<float>{1, 2, 3}));
}

TEST(AngleCriterion, KeepsTheNearestWhereTheySurroundThePoint) {
  const Eigen::Matrix3Xf points = cross();
  const auto near = nearestNeighborhoods(points, 8);
  const auto found = membersOf(angleCriterionNeighbors(points, up(points), near, 4, 1.6), 0);
  EXPECT_EQ(std::set<std::uint32_t>(found.begin(), found.end()),
            (std::set<std::uint32_t>{1, 2, 3, 4}));
}

TEST(AngleCriterion, LeavesGapsThatNobodyFills) {
  Eigen::Matrix3Xf line = Eigen::Matrix3Xf::Zero(3, 9);
  line.row(0) = Eigen::RowVectorXf::LinSpaced(9, 0, 8);
  const auto near = nearestNeighborhoods(line, 8);
  EXPECT_EQ(membersOf(angleCriterionNeighbors(line, up(line), near, 4), 0).size(), 4U);
}

TEST(TangentNeighbors, StopWhenAsked) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const auto near = nearestNeighborhoods(points, 12);
  using test::stopsWhenAsked;
  EXPECT_TRUE(stopsWhenAsked(
      [&](const Progress& p) { (void)voronoiNeighbors(points, up(points), near, p); }));
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) {
    (void)angleCriterionNeighbors(points, up(points), near, 6, 1.6, p);
  }));
}

} // namespace
} // namespace espalier
