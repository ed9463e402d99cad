#include "core/graph/components.h"
#include "core/graph/neighborhood_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr std::array allKinds = {LinkKind::nearest, LinkKind::angles, LinkKind::voronoi};

/// A trunk that a scanner sampled in 12 lines along it, in which points lie nine times as
/// dense as the lines.
Eigen::Matrix3Xf sampledInLines() {
  constexpr int lines = 12;
  constexpr int perLine = 60;
  Eigen::Matrix3Xf points(3, lines * perLine);
  for (int line = 0; line < lines; ++line) {
    const double angle = 2 * std::numbers::pi * line / lines;
    for (int i = 0; i < perLine; ++i)
      points.col(line * perLine + i) =
          Eigen::Vector3d(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.003 * i).cast<float>();
  }
  return points;
}

std::size_t partsOf(const Eigen::Matrix3Xf& points, LinkKind kind) {
  return connectedComponents(NeighborhoodGraph(points, {7, kind})).count();
}

TEST(PointLinks, OfTheNearestLeaveTheLinesOfAScannerApart) {
  EXPECT_EQ(partsOf(sampledInLines(), LinkKind::nearest), 12U);
}

TEST(PointLinks, AllAroundAndOfVoronoiCellsJoinThem) {
  EXPECT_EQ(partsOf(sampledInLines(), LinkKind::angles), 1U);
  EXPECT_EQ(partsOf(sampledInLines(), LinkKind::voronoi), 1U);
}

TEST(PointLinks, AreListedOnceAtBothEnds) {
  const Eigen::Matrix3Xf points = sampledInLines();
  for (const LinkKind kind : allKinds) {
    const NeighborhoodGraph graph(points, {7, kind});
    for (Eigen::Index i = 0; i < graph.size(); ++i)
      for (const NeighborhoodGraph::Link& link : graph.links(i)) {
        EXPECT_NE(link.to, i);
        EXPECT_FLOAT_EQ(link.length, (points.col(i) - points.col(link.to)).norm());
        EXPECT_EQ(std::ranges::count(graph.links(i), link.to, &NeighborhoodGraph::Link::to), 1);
        EXPECT_EQ(std::ranges::count(graph.links(link.to), static_cast<std::uint32_t>(i),
                                     &NeighborhoodGraph::Link::to),
                  1);
      }
  }
}

TEST(PointLinks, CopeWithFewPointsOfAnyShape) {
  for (const LinkKind kind : allKinds)
    for (const Eigen::Index count : {0, 1, 2, 3, 5}) {
      EXPECT_EQ(NeighborhoodGraph(Eigen::Matrix3Xf::Zero(3, count), {7, kind}).size(), count);
      Eigen::Matrix3Xf line = Eigen::Matrix3Xf::Zero(3, count);
      for (Eigen::Index i = 0; i < count; ++i)
        line(0, i) = static_cast<float>(i);
      EXPECT_EQ(NeighborhoodGraph(line, {7, kind}).size(), count);
    }
}

} // namespace
} // namespace espalier
