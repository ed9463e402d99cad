#include "core/base/error.h"
#include "core/evaluate/tolerance_curve.h"
#include "core/pipeline/grow_branches.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/support/clouds.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

std::shared_ptr<const PointCloud> cloudOf(const Eigen::Matrix3Xf& points) {
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>());
  return std::make_shared<const PointCloud>(std::move(raw));
}

/// A trunk from the origin to z = 2, with a node every 0.2.
Skeleton trunk() {
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i <= 10; ++i)
    last = plant.add({.position = {0, 0, 0.2 * i}, .radius = 0.04, .parent = last});
  return plant;
}

Eigen::Matrix3Xf trunkPoints() {
  return test::cylinder({0, 0, 0}, {0, 0, 2}, 0.04, 0.02);
}

/// All of it in one plant.
Skeleton together(const Skeleton& plant, const std::vector<GrownBranch>& branches) {
  Skeleton whole = plant;
  SkeletonEditor editor(whole);
  for (const GrownBranch& branch : branches)
    (void)addCarried(editor, branch.on, branch.part);
  (void)editor.commit();
  return whole;
}

std::ptrdiff_t countTips(const Skeleton& plant) {
  const std::vector<NodeId> ids = plant.ids();
  return std::ranges::count_if(ids, [&](NodeId id) { return plant.children(id).empty(); });
}

double farthestTip(const Skeleton& plant, const Eigen::Vector3d& place) {
  double nearest = 1e9;
  for (const NodeId id : plant.ids())
    nearest = std::min(nearest, (plant[id].position - place).norm());
  return nearest;
}

// The bark stands off the trunk in places, farther than what an edge explains, but not twice as
// far.
TEST(GrownFromUnexplained, GrowsNothingOfRoughBark) {
  const Eigen::Matrix3Xf branch = test::cylinder({0.04, 0, 0.8}, {0.8, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf bark = test::cylinder({-0.12, 0, 1.2}, {-0.12, 0, 1.5}, 0.005, 0.005);
  const auto cloud = cloudOf(test::both(trunkPoints(), test::both(branch, bark)));
  const std::vector<GrownBranch> branches =
      grownFromUnexplained(trunk(), cloud, {.tolerance = 0.05});
  ASSERT_EQ(branches.size(), 1U);
  EXPECT_NEAR(trunk()[branches[0].on].position.z(), 0.8, 0.25);
  const auto barkAlone = cloudOf(test::both(trunkPoints(), bark));
  EXPECT_THROW((void)grownFromUnexplained(trunk(), barkAlone, {.tolerance = 0.05}), Error);
}

// Two branches leave the trunk, at z = 0.8 to the right and at z = 1.2 to the left.
TEST(GrownFromUnexplained, HangsEachMissingBranchOnTheNodeItLeaves) {
  const Eigen::Matrix3Xf right = test::cylinder({0.04, 0, 0.8}, {0.8, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf left = test::cylinder({-0.04, 0, 1.2}, {-0.8, 0, 1.6}, 0.02, 0.01);
  const auto cloud = cloudOf(test::both(trunkPoints(), test::both(right, left)));
  const std::vector<GrownBranch> branches = grownFromUnexplained(trunk(), cloud);
  ASSERT_EQ(branches.size(), 2U);
  EXPECT_NEAR(trunk()[branches[0].on].position.z(), 0.8, 0.25);
  EXPECT_NEAR(trunk()[branches[1].on].position.z(), 1.2, 0.25);
  const Skeleton whole = together(trunk(), branches);
  EXPECT_EQ(whole.roots().size(), 1U);
  EXPECT_EQ(countTips(whole), 3);
  EXPECT_LT(farthestTip(whole, {0.8, 0, 1.2}), 0.08);
  EXPECT_LT(farthestTip(whole, {-0.8, 0, 1.6}), 0.08);
  for (const GrownBranch& branch : branches)
    for (const NodeId id : branch.part.ids())
      EXPECT_LE(branch.part[id].radius, 0.04) << "no thicker than the trunk";
}

// The second piece begins 0.3 beyond the first: nearer to it than to the trunk.
TEST(GrownFromUnexplained, HangsAPieceOnTheOneItIsNearestTo) {
  const Eigen::Matrix3Xf inner = test::cylinder({0.04, 0, 1}, {0.6, 0, 1}, 0.02, 0.01);
  const Eigen::Matrix3Xf outer = test::cylinder({0.75, 0, 1}, {1.3, 0, 1}, 0.02, 0.01);
  const auto cloud = cloudOf(test::both(trunkPoints(), test::both(inner, outer)));
  const std::vector<GrownBranch> branches =
      grownFromUnexplained(trunk(), cloud, {.widestJoin = 0.4});
  ASSERT_EQ(branches.size(), 1U);
  const Skeleton whole = together(trunk(), branches);
  EXPECT_EQ(countTips(whole), 2) << "one branch, in a line";
  EXPECT_LT(farthestTip(whole, {1.3, 0, 1}), 0.08);
}

TEST(GrownFromUnexplained, LeavesWhatIsTooFarOffToBeOfThePlant) {
  const Eigen::Matrix3Xf near = test::cylinder({0.04, 0, 1}, {0.6, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf far = test::cylinder({3, 0, 1}, {3.6, 0, 1}, 0.02, 0.01);
  const auto cloud = cloudOf(test::both(trunkPoints(), test::both(near, far)));
  const Skeleton whole = together(trunk(), grownFromUnexplained(trunk(), cloud));
  for (const NodeId id : whole.ids())
    EXPECT_LT(whole[id].position.x(), 1);
}

TEST(GrownFromUnexplained, SeesNothingOfPointsThatAreSetAside) {
  const Eigen::Matrix3Xf branch = test::cylinder({0.04, 0, 1}, {0.8, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf trunkAlone = trunkPoints();
  const auto cloud = cloudOf(test::both(trunkAlone, branch));
  std::vector<Eigen::Index> ofBranch;
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (cloud->fileOrder()[static_cast<std::size_t>(i)] >= trunkAlone.cols()) ofBranch.push_back(i);
  GrowOptions options;
  options.pipeline.leftOut = PointSet::of(ofBranch);
  EXPECT_THROW((void)grownFromUnexplained(trunk(), cloud, options), Error);
  EXPECT_EQ(grownFromUnexplained(trunk(), cloud).size(), 1U);
}

// Side branches of a simulated tree are taken away; they come back at about the length they had.
TEST(GrownFromUnexplained, BringsBackWhatATreeLost) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const auto cloud = std::make_shared<const PointCloud>(tree.cloud);
  Skeleton pruned = tree.truth;
  SkeletonEditor editor(pruned);
  int kept = 0;
  for (const NodeId id : tree.truth.ids())
    if (pruned.contains(id) && pruned[id].edge == EdgeType::branching && pruned[id].parent &&
        ++kept % 3 == 0)
      removeSubtree(editor, id);
  (void)editor.commit();
  ASSERT_LT(pruned.size(), tree.truth.size());
  const double distance = 3 * pointSpacing(cloud->positions());
  const auto f = [&](const Skeleton& plant) {
    return toleranceCurve(plant, tree.truth, {.distances = {distance}}).scores.front().f();
  };
  const Skeleton whole = together(pruned, grownFromUnexplained(pruned, cloud));
  EXPECT_EQ(whole.roots().size(), pruned.roots().size());
  EXPECT_GT(f(whole), f(pruned));
}

TEST(GrownBranches, GrowFromThePointsChosenAlone) {
  const Eigen::Matrix3Xf right = test::cylinder({0.04, 0, 0.8}, {0.8, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf left = test::cylinder({-0.04, 0, 1.2}, {-0.8, 0, 1.6}, 0.02, 0.01);
  const auto cloud = cloudOf(test::both(trunkPoints(), test::both(right, left)));
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (cloud->position(i).x() > 0.1) chosen.push_back(i);
  const std::vector<GrownBranch> branches = grownBranches(trunk(), cloud, chosen);
  ASSERT_EQ(branches.size(), 1U);
  for (const NodeId id : branches[0].part.ids())
    EXPECT_GT(branches[0].part[id].position.x(), -0.01);
}

/// The columns of the points in a box.
std::vector<Eigen::Index> inside(const PointCloud& cloud, const Eigen::AlignedBox3d& box) {
  std::vector<Eigen::Index> columns;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    if (box.contains(cloud.position(i))) columns.push_back(i);
  return columns;
}

// A lasso about a branch takes bark of the trunk as well: that has its nodes already.
TEST(GrownBranches, LeaveOutWhatThePlantExplains) {
  const Eigen::Matrix3Xf branch = test::cylinder({0.04, 0, 0.8}, {0.8, 0, 1.2}, 0.02, 0.01);
  const auto cloud = cloudOf(test::both(trunkPoints(), branch));
  const std::vector<GrownBranch> branches = grownBranches(
      trunk(), cloud, inside(*cloud, {Eigen::Vector3d(-1, -1, 0.4), Eigen::Vector3d(1, 1, 1.4)}));
  ASSERT_EQ(branches.size(), 1U);
  const Skeleton& part = branches[0].part;
  for (const NodeId id : part.ids())
    EXPECT_TRUE(!part[id].parent || part[id].position.x() > 0.05) << "along the trunk";
  EXPECT_LT(farthestTip(together(trunk(), branches), {0.8, 0, 1.2}), 0.08);
}

// The branch begins beside the trunk, nearer to the node above than to the one below, and rises.
TEST(GrownBranches, BeginForward) {
  const Eigen::Matrix3Xf branch = test::cylinder({0.12, 0, 0.75}, {0.3, 0, 1.6}, 0.02, 0.01);
  const auto cloud = cloudOf(test::both(trunkPoints(), branch));
  const std::vector<GrownBranch> branches = grownBranches(
      trunk(), cloud, inside(*cloud, {Eigen::Vector3d(0.07, -1, 0), Eigen::Vector3d(1, 1, 2)}));
  ASSERT_EQ(branches.size(), 1U);
  EXPECT_NEAR(trunk()[branches[0].on].position.z(), 0.6, 1e-9);
}

TEST(GrownBranches, AreRefusedForTooFewPoints) {
  const auto cloud = cloudOf(trunkPoints());
  EXPECT_THROW((void)grownBranches(trunk(), cloud, {0, 1, 2}), Error);
  EXPECT_THROW((void)grownBranches(trunk(), cloud, {}), Error);
  EXPECT_THROW((void)grownFromUnexplained(trunk(), cloud, {.tolerance = 0.1}), Error)
      << "all are explained";
}

TEST(GrownBranches, StopWhenAsked) {
  const auto cloud =
      cloudOf(test::both(trunkPoints(), test::cylinder({0.04, 0, 1}, {0.8, 0, 1.2}, 0.02, 0.01)));
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)grownFromUnexplained(trunk(), cloud, {}, progress); }));
}

} // namespace
} // namespace espalier
