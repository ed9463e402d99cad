#include "core/base/random.h"
#include "core/graph/components.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace espalier {
namespace {

/// Sticks of points, 1 apart in each, at distances of 10, 20, 30 ... from one another.
Eigen::Matrix3Xf stripes(int count, int length) {
  Eigen::Matrix3Xf points(3, count * length);
  for (int i = 0; i < count * length; ++i) {
    const int stripe = i / length;
    points.col(i) = Eigen::Vector3f(5.0F * static_cast<float>(stripe * (stripe + 1)),
                                    static_cast<float>(i % length), 0);
  }
  return points;
}

double totalLength(const NeighborhoodGraph& graph) {
  double sum = 0;
  for (Eigen::Index i = 0; i < graph.size(); ++i)
    for (const NeighborhoodGraph::Link& link : graph.links(i))
      sum += static_cast<double>(link.length);
  return sum / 2;
}

std::size_t linksOf(const NeighborhoodGraph& graph) {
  std::size_t ends = 0;
  for (Eigen::Index i = 0; i < graph.size(); ++i)
    ends += graph.links(i).size();
  return ends / 2;
}

TEST(NeighborhoodGraph, ListsEachLinkOnceAtBothEnds) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const NeighborhoodGraph graph(points, 7);
  for (Eigen::Index i = 0; i < graph.size(); ++i) {
    EXPECT_GE(graph.links(i).size(), 7U);
    for (const NeighborhoodGraph::Link& link : graph.links(i)) {
      EXPECT_NE(link.to, i);
      EXPECT_NEAR(link.length, (points.col(i) - points.col(link.to)).norm(), 1e-5);
      const auto back = graph.links(link.to);
      EXPECT_EQ(std::count_if(back.begin(), back.end(), [&](const auto& l) { return l.to == i; }),
                1);
    }
  }
}

TEST(Components, AreNumberedFromTheLargest) {
  const Eigen::Matrix3Xf points = test::both(stripes(1, 5), stripes(3, 20).rightCols(20));
  const Components components = connectedComponents(NeighborhoodGraph(points, 2));
  EXPECT_EQ(components.sizes, (std::vector<Eigen::Index>{20, 5}));
  EXPECT_EQ(components.ofPoint[0], 1U);
  EXPECT_EQ(components.ofPoint[24], 0U);
}

TEST(Joined, UsesTheShortestBridges) {
  const Eigen::Matrix3Xf points = stripes(5, 20);
  const NeighborhoodGraph apart(points, 2);
  const NeighborhoodGraph together = joined(apart, points);
  EXPECT_EQ(connectedComponents(together).count(), 1U);
  EXPECT_EQ(linksOf(together), linksOf(apart) + 4);
  EXPECT_NEAR(totalLength(together) - totalLength(apart), 10 + 20 + 30 + 40, 1e-3);
}

TEST(Joined, EqualsTheMinimumSpanningTreeOfTheGaps) {
  Random random(7);
  for (int round = 0; round < 20; ++round) {
    // Pairs of points, each pair a component: the bridges are a minimum spanning tree of the pairs.
    constexpr int pairs = 40;
    Eigen::Matrix3Xf points(3, 2 * pairs);
    for (int i = 0; i < pairs; ++i) {
      points.col(2 * i) = (random.uniform(50, 100) * random.direction()).cast<float>();
      points.col(2 * i + 1) = points.col(2 * i) + Eigen::Vector3f(0.01F, 0, 0);
    }
    const NeighborhoodGraph apart(points, 1);
    ASSERT_EQ(connectedComponents(apart).count(), static_cast<std::size_t>(pairs));
    // Prim's algorithm over the pairs.
    std::vector<double> nearest(pairs, 1e30);
    std::vector<bool> isIn(pairs, false);
    double expected = 0;
    int at = 0;
    for (int step = 0; step < pairs; ++step) {
      isIn[static_cast<std::size_t>(at)] = true;
      if (step > 0) expected += nearest[static_cast<std::size_t>(at)];
      int next = -1;
      for (int i = 0; i < pairs; ++i) {
        const auto p = static_cast<std::size_t>(i);
        if (isIn[p]) continue;
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            nearest[p] = std::min(
                nearest[p],
                static_cast<double>((points.col(2 * i + a) - points.col(2 * at + b)).norm()));
        if (next < 0 || nearest[p] < nearest[static_cast<std::size_t>(next)]) next = i;
      }
      at = next;
    }
    EXPECT_NEAR(totalLength(joined(apart, points)) - totalLength(apart), expected, 1e-2);
  }
}

TEST(Joined, LeavesGapsThatAreTooWide) {
  const Eigen::Matrix3Xf points = stripes(4, 10);
  const NeighborhoodGraph graph = joined(NeighborhoodGraph(points, 2), points, 25);
  EXPECT_EQ(connectedComponents(graph).count(), 2U);
}

TEST(Joined, StopsWhenAsked) {
  const Eigen::Matrix3Xf points = stripes(4, 10);
  const NeighborhoodGraph graph(points, 2);
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)joined(graph, points, 1000, progress); }));
}

} // namespace
} // namespace espalier
