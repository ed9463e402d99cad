#include "core/base/error.h"
#include "core/base/random.h"
#include "core/graph/find_root.h"
#include "core/reconstruct/branch_structure_graph.h"
#include "core/reconstruct/flat_overlap.h"
#include "core/reconstruct/tree_equations.h"
#include "tests/support/clouds.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

constexpr std::uint32_t none = 0xffffffff;

// The same problem as a dense matrix.
TEST(TreeEquations, GiveWhatDenseEliminationGives) {
  Random random(3);
  constexpr int count = 12;
  std::vector<std::uint32_t> parents = {none};
  for (std::size_t i = 1; i < count; ++i)
    parents.push_back(static_cast<std::uint32_t>(random.below(i)));
  TreeEquations equations(parents);
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d wanted = random.direction();
    const double weight = random.uniform(0.1, 2);
    equations.ask(static_cast<std::size_t>(i), wanted, weight);
    left(i, i) += weight;
    right.row(i) += weight * wanted.transpose();
    if (i == 0) continue;
    const auto parent = static_cast<Eigen::Index>(parents[static_cast<std::size_t>(i)]);
    const double sign = i % 2 == 0 ? 1 : -1;
    equations.askOfEdge(static_cast<std::size_t>(i), sign, 2 * wanted, weight);
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(count);
    row[i] = 1;
    row[parent] = sign;
    left += weight * row.transpose() * row;
    right += weight * row.transpose() * (2 * wanted).transpose();
  }
  const Eigen::MatrixXd expected = left.partialPivLu().solve(right);
  const std::vector<Eigen::Vector3d> solved = equations.solved();
  for (int i = 0; i < count; ++i)
    EXPECT_LT((solved[static_cast<std::size_t>(i)] - expected.row(i).transpose()).norm(), 1e-9);
}

TEST(TreeEquations, LeaveAtZeroWhatNobodyAskedFor) {
  const std::vector<std::uint32_t> parents = {none, 0};
  EXPECT_EQ(TreeEquations(parents).solved()[1], Eigen::Vector3d::Zero());
}

Frustum bar(const Eigen::Vector3d& to, double radius = 0.1) {
  return {Eigen::Vector3d::Zero(), to, radius, radius};
}

TEST(FlatOverlap, IsTheShareOfTheSmallerArea) {
  EXPECT_NEAR(flatOverlap(bar({1, 0, 0}), bar({1, 0, 0})), 1, 1e-9);
  EXPECT_NEAR(flatOverlap(bar({1, 0, 0}), bar({0.5, 0, 0})), 1, 1e-9);
  EXPECT_NEAR(flatOverlap(bar({1, 0, 0}), bar({-1, 0, 0})), 0, 1e-9);
  // Across each other: a square of 0.1 of the bar 0.2 wide and 1 long.
  EXPECT_NEAR(flatOverlap(bar({1, 0, 0}), bar({0, 0, 1})), 0.1 * 0.1 / 0.2, 1e-9);
}

TEST(FlatOverlap, TakesTipsAndNothing) {
  const Frustum pointed = {Eigen::Vector3d::Zero(), {1, 0, 0}, 0.1, 0};
  EXPECT_NEAR(flatOverlap(pointed, bar({1, 0, 0})), 1, 1e-9);
  EXPECT_EQ(flatOverlap(bar({1, 0, 0}, 0), bar({1, 0, 0})), 0);
  EXPECT_EQ(flatOverlap(bar({0, 0, 0}), bar({1, 0, 0})), 0);
}

TEST(FlatOverlap, TurnsWithThePieces) {
  const Eigen::Matrix3d turn = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.2).normalized().matrix();
  const Eigen::Vector3d a(1, 0, 0);
  const Eigen::Vector3d b(0.9, 0.15, 0);
  EXPECT_NEAR(flatOverlap(bar(turn * a), bar(turn * b)), flatOverlap(bar(a), bar(b)), 1e-9);
}

BranchStructureOptions branchStructure() {
  return {.radiusShare = 1, .spacing = 0.15};
}

TEST(BranchStructure, StaysOnTheWoodAndReachesItsTips) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Skeleton skeleton = skeletonByBranchStructure(points, findRoot(points), branchStructure());
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_LT(test::farthestFromFork(skeleton), 0.08);
  double top = 0;
  for (const NodeId id : skeleton.ids())
    top = std::max(top, skeleton[id].position.z());
  EXPECT_GT(top, 2 + 1.5 * 0.819 - 0.15);
}

// All points of a stick are 0.04 off its axis; what carries most comes nearer.
TEST(BranchStructure, PullsTheHeavyBranchToTheAxis) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 3}, 0.04, 0.02);
  const auto bend = [&](int rounds) {
    BranchStructureOptions with = branchStructure();
    with.rounds = rounds;
    const Skeleton skeleton = skeletonByBranchStructure(points, findRoot(points), with);
    double length = 0;
    for (const NodeId id : skeleton.ids())
      if (const auto parent = skeleton[id].parent)
        length += (skeleton[id].position - skeleton[*parent].position).head<2>().norm();
    return length / static_cast<double>(skeleton.size());
  };
  EXPECT_LT(bend(3), bend(0));
}

TEST(BranchStructure, FiltersShortEdgesAndOverlaps) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  BranchStructureOptions all = branchStructure();
  all.leastEdge = 0;
  all.overlap = 1;
  all.spacing = 10;
  const std::size_t before = skeletonByBranchStructure(points, findRoot(points), all).size();
  all.leastEdge = 0.3;
  const std::size_t longOnly = skeletonByBranchStructure(points, findRoot(points), all).size();
  all.leastEdge = 0;
  all.overlap = 0.3;
  const std::size_t merged = skeletonByBranchStructure(points, findRoot(points), all).size();
  EXPECT_LT(longOnly, before);
  EXPECT_LT(merged, before);
}

TEST(BranchStructure, RefusesARootThatCarriesLessThanHalf) {
  BranchStructureOptions strict = branchStructure();
  strict.widestGap = 1;
  EXPECT_THROW(
      (void)skeletonByBranchStructure(test::both(test::cylinder({0, 0, 0}, {0, 0, 0.5}, 0.04, 0.02),
                                                 test::cylinder({9, 0, 0}, {9, 0, 3}, 0.04, 0.02)),
                                      0, strict),
      Error);
}

TEST(BranchStructure, CopesWithCoincidentAndSinglePoints) {
  EXPECT_LE(skeletonByBranchStructure(Eigen::Matrix3Xf::Ones(3, 50), 0, branchStructure()).size(),
            50U);
  EXPECT_EQ(skeletonByBranchStructure(Eigen::Matrix3Xf::Ones(3, 1), 0, branchStructure()).size(),
            1U);
}

} // namespace
} // namespace espalier
