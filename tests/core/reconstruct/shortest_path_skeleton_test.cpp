#include "core/base/error.h"
#include "core/graph/find_root.h"
#include "core/reconstruct/point_tree.h"
#include "core/reconstruct/shortest_path_skeleton.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr ShortestPathOptions shortestPathOptions{.spacing = 0.15, .leastRadius = 0.04};

/// Points 0.01 apart from one place to another, without the first.
Eigen::Matrix3Xf lineAbove(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const auto count = static_cast<Eigen::Index>((to - from).norm() / 0.01 + 0.5);
  Eigen::Matrix3Xf points(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    points.col(i) = (from + static_cast<double>(i + 1) / static_cast<double>(count) * (to - from))
                        .cast<float>();
  return points;
}

TEST(PointTree, LeadsToEveryPointParentsFirst) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const PointTree tree = shortestPathTree(points, 700, {});
  ASSERT_EQ(tree.size(), static_cast<std::size_t>(points.cols()));
  EXPECT_EQ(tree.positions.front(), points.col(700).cast<double>());
  EXPECT_EQ(tree.parents.front(), PointTree::none);
  for (std::size_t i = 1; i < tree.size(); ++i)
    EXPECT_LT(tree.parents[i], i);
}

// 0.3, 0.4 and 0.5 long, each on the one before, and 0.2 besides the second.
TEST(PointTree, MeasuresWhatNodesCarry) {
  PointTree tree;
  tree.positions = {{0, 0, 0}, {0, 0, 0.3}, {0, 0, 0.7}, {0.2, 0, 0.3}, {0, 0, 1.2}};
  tree.parents = {PointTree::none, 0, 1, 1, 2};
  EXPECT_NEAR(tree.longestDown()[0], 1.2, 1e-12);
  EXPECT_NEAR(tree.longestDown()[1], 0.9, 1e-12);
  EXPECT_NEAR(tree.lengthCarried()[0], 1.4, 1e-12);
  EXPECT_EQ(tree.lengthCarried()[4], 0);
}

// Four small steps of 0.1 cost 0.04, a leap of 0.3 over the corner 0.09.
TEST(PointTree, PrefersSmallStepsToALeapWherePowerIsTwo) {
  Eigen::Matrix3Xf points(3, 5);
  points << 0, 0.05F, 0.15F, 0.25F, 0.3F, 0, 0.086F, 0.086F, 0.086F, 0, 0, 0, 0, 0, 0;
  const auto steps = [&](double power) {
    const PointTree tree = shortestPathTree(points, 0, {.neighbors = 4, .power = power});
    std::size_t node = 0;
    for (std::size_t i = 0; i < tree.size(); ++i)
      if (std::abs(tree.positions[i].x() - 0.3) < 1e-6) node = i;
    int count = 0;
    for (; node != 0; node = tree.parents[node])
      ++count;
    return count;
  };
  EXPECT_EQ(steps(1), 1);
  EXPECT_EQ(steps(2), 4);
}

TEST(PointTree, GivesNoEdgeLongerThanTheSpacing) {
  PointTree tree;
  tree.positions = {{0, 0, 0}, {0, 0, 1}, {0, 0, 1.2}};
  tree.parents = {PointTree::none, 0, 1};
  const Skeleton skeleton = skeletonOf(tree, 0.25);
  EXPECT_EQ(skeleton.size(), 6U);
  for (const NodeId id : skeleton.ids())
    if (const auto parent = skeleton[id].parent) {
      EXPECT_LE((skeleton[id].position - skeleton[*parent].position).norm(), 0.25 + 1e-9);
    }
}

TEST(ShortestPaths, FindTheForkOfAFork) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Skeleton skeleton = skeletonByShortestPaths(points, findRoot(points), shortestPathOptions);
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_LT(test::farthestFromFork(skeleton), 0.05); // on the wood, or in it
  double top = 0;
  for (const NodeId id : skeleton.ids())
    top = std::max(top, skeleton[id].position.z());
  EXPECT_GT(top, 2 + 1.5 * 0.819 - 0.1);
}

TEST(ShortestPaths, MakeOnePathOfALine) {
  const Skeleton skeleton =
      skeletonByShortestPaths(lineAbove({0, 0, 0}, {0, 0, 3}), 0, shortestPathOptions);
  EXPECT_EQ(test::countTips(skeleton), 1);
  EXPECT_NEAR(static_cast<double>(skeleton.size()), 3 / 0.15 + 1, 2);
}

// A branch of 0.05 is 1.7 % of a path of 3, one of 0.1 is 3.3 %.
TEST(ShortestPaths, PruneSmallSharesOnly) {
  ShortestPathOptions thin = shortestPathOptions;
  thin.leastRadius = 0.005;
  const Eigen::Matrix3Xf trunk = lineAbove({0, 0, 0}, {0, 0, 3});
  const auto tips = [&](double length) {
    const Eigen::Matrix3Xf branch = lineAbove({0, 0, 0.01}, {length, 0, 0.01});
    return test::countTips(skeletonByShortestPaths(test::both(trunk, branch), 0, thin));
  };
  EXPECT_EQ(tips(0.05), 1);
  EXPECT_EQ(tips(0.1), 2);
}

TEST(ShortestPaths, MergeWhatRunsSideBySideWithinTheWood) {
  const Eigen::Matrix3Xf points =
      test::both(lineAbove({0, 0, 0}, {0.01, 0, 0.3}), lineAbove({0, 0, 0}, {-0.01, 0, 0.3}));
  EXPECT_EQ(test::countTips(skeletonByShortestPaths(points, 0, shortestPathOptions)), 1);
  const Eigen::Matrix3Xf apart =
      test::both(lineAbove({0, 0, 0}, {0.2, 0, 0.3}), lineAbove({0, 0, 0}, {-0.2, 0, 0.3}));
  EXPECT_EQ(test::countTips(skeletonByShortestPaths(apart, 0, shortestPathOptions)), 2);
}

TEST(ShortestPaths, RefuseARootThatCarriesLessThanHalf) {
  ShortestPathOptions strict = shortestPathOptions;
  strict.widestGap = 1;
  EXPECT_THROW((void)skeletonByShortestPaths(
                   test::both(lineAbove({0, 0, 0}, {0, 0, 0.5}), lineAbove({9, 0, 0}, {9, 0, 3})),
                   0, strict),
               Error);
}

TEST(ShortestPaths, CopeWithCoincidentAndSinglePoints) {
  EXPECT_LE(skeletonByShortestPaths(Eigen::Matrix3Xf::Ones(3, 50), 0, shortestPathOptions).size(),
            2U);
  EXPECT_EQ(skeletonByShortestPaths(Eigen::Matrix3Xf::Ones(3, 1), 0, shortestPathOptions).size(),
            1U);
}

} // namespace
} // namespace espalier
