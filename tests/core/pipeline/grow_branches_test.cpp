#include "core/base/error.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/pipeline/grow_branches.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/support/clouds.h"
#include "tests/support/course.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace espalier {
namespace {

std::shared_ptr<const PointCloud> scanOf(const Eigen::Matrix3Xf& points) {
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
  (void)addGrown(editor, branches);
  (void)editor.commit();
  return whole;
}

/// What it has more than a plant.
std::vector<NodeId> added(const Skeleton& whole, const Skeleton& plant) {
  std::vector<NodeId> ids = whole.ids();
  std::erase_if(ids, [&](NodeId id) { return plant.contains(id); });
  return ids;
}

/// Every third branch of a plant is taken away, with all it carries.
Skeleton withoutEveryThirdBranch(const Skeleton& plant) {
  Skeleton pruned = plant;
  SkeletonEditor editor(pruned);
  int met = 0;
  for (const NodeId id : plant.ids())
    if (pruned.contains(id) && pruned[id].edge == EdgeType::branching && pruned[id].parent &&
        ++met % 3 == 0)
      removeSubtree(editor, id);
  (void)editor.commit();
  return pruned;
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
  const auto cloud = scanOf(test::both(trunkPoints(), test::both(branch, bark)));
  const std::vector<GrownBranch> branches =
      grownFromUnexplained(trunk(), cloud, {.tolerance = 0.05});
  ASSERT_EQ(branches.size(), 1U);
  EXPECT_NEAR(trunk()[branches[0].on].position.z(), 0.8, 0.25);
  const auto barkAlone = scanOf(test::both(trunkPoints(), bark));
  EXPECT_THROW((void)grownFromUnexplained(trunk(), barkAlone, {.tolerance = 0.05}), Error);
}

TEST(GrownFromUnexplained, GrowsNothingOfABladeAlongAnAxis) {
  Eigen::Matrix3Xf blade(3, 51 * 101);
  for (int i = 0; i <= 100; ++i)
    for (int k = 0; k <= 50; ++k)
      blade.col(51 * i + k) << 0.04F + 0.01F * static_cast<float>(k), 0,
          0.5F + 0.01F * static_cast<float>(i);
  const auto alone = scanOf(test::both(trunkPoints(), blade));
  EXPECT_THROW((void)grownFromUnexplained(trunk(), alone), Error);
  std::vector<Eigen::Index> chosen(static_cast<std::size_t>(blade.cols()));
  std::iota(chosen.begin(), chosen.end(), trunkPoints().cols());
  EXPECT_FALSE(grownBranches(trunk(), alone, chosen).empty()) << "who chooses points means them";
}

// Two branches leave the trunk, at z = 0.8 to the right and at z = 1.2 to the left.
TEST(GrownFromUnexplained, AttachesEachMissingBranchToTheNodeItLeaves) {
  const Eigen::Matrix3Xf right = test::cylinder({0.04, 0, 0.8}, {0.8, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf left = test::cylinder({-0.04, 0, 1.2}, {-0.8, 0, 1.6}, 0.02, 0.01);
  const auto cloud = scanOf(test::both(trunkPoints(), test::both(right, left)));
  const std::vector<GrownBranch> branches = grownFromUnexplained(trunk(), cloud);
  ASSERT_EQ(branches.size(), 2U);
  EXPECT_NEAR(trunk()[branches[0].on].position.z(), 0.8, 0.25);
  EXPECT_NEAR(trunk()[branches[1].on].position.z(), 1.2, 0.25);
  const Skeleton whole = together(trunk(), branches);
  EXPECT_EQ(whole.roots().size(), 1U);
  EXPECT_EQ(test::countTips(whole), 3);
  EXPECT_LT(farthestTip(whole, {0.8, 0, 1.2}), 0.08);
  EXPECT_LT(farthestTip(whole, {-0.8, 0, 1.6}), 0.08);
  for (const GrownBranch& branch : branches)
    for (const NodeId id : branch.part.ids())
      EXPECT_LE(branch.part[id].radius, 0.04) << "no thicker than the trunk";
}

// The second piece begins 0.3 beyond the first: nearer to it than to the trunk.
TEST(GrownFromUnexplained, AttachesAPieceToTheOneItIsNearestTo) {
  const Eigen::Matrix3Xf inner = test::cylinder({0.04, 0, 1}, {0.6, 0, 1}, 0.02, 0.01);
  const Eigen::Matrix3Xf outer = test::cylinder({0.75, 0, 1}, {1.3, 0, 1}, 0.02, 0.01);
  const auto cloud = scanOf(test::both(trunkPoints(), test::both(inner, outer)));
  const std::vector<GrownBranch> branches =
      grownFromUnexplained(trunk(), cloud, {.widestJoin = 0.4});
  ASSERT_EQ(branches.size(), 1U);
  const Skeleton whole = together(trunk(), branches);
  EXPECT_EQ(test::countTips(whole), 2) << "one branch, in a line";
  EXPECT_LT(farthestTip(whole, {1.3, 0, 1}), 0.08);
}

TEST(GrownFromUnexplained, LeavesWhatIsTooFarOffToBeOfThePlant) {
  const Eigen::Matrix3Xf near = test::cylinder({0.04, 0, 1}, {0.6, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf far = test::cylinder({3, 0, 1}, {3.6, 0, 1}, 0.02, 0.01);
  const auto cloud = scanOf(test::both(trunkPoints(), test::both(near, far)));
  const Skeleton whole = together(trunk(), grownFromUnexplained(trunk(), cloud));
  for (const NodeId id : whole.ids())
    EXPECT_LT(whole[id].position.x(), 1);
}

TEST(GrownFromUnexplained, SeesNothingOfPointsThatAreSetAside) {
  const Eigen::Matrix3Xf branch = test::cylinder({0.04, 0, 1}, {0.8, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf trunkAlone = trunkPoints();
  const auto cloud = scanOf(test::both(trunkAlone, branch));
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
  const Skeleton pruned = withoutEveryThirdBranch(tree.truth);
  ASSERT_LT(pruned.size(), tree.truth.size());
  const double distance = 3 * pointSpacing(cloud->positions());
  const auto f = [&](const Skeleton& plant) {
    return toleranceCurve(plant, tree.truth, {.distances = {distance}}).scores.front().f();
  };
  const Skeleton whole = together(pruned, grownFromUnexplained(pruned, cloud));
  EXPECT_EQ(whole.roots().size(), pruned.roots().size());
  EXPECT_GT(f(whole), f(pruned));
}

// Branches of reconstructed shrubs are taken away: what grows there turns back nowhere, and keeps
// to the points.
TEST(GrownFromUnexplained, TurnsBackNowhereAndKeepsToThePoints) {
  for (const std::uint64_t seed : {1, 2}) {
    const Skeleton truth =
        growPlant({.architecture = Architecture::shrub, .height = 4, .segments = 200}, seed);
    const auto cloud =
        std::make_shared<const PointCloud>(scan(truth, {.points = 40'000}, seed).points);
    const double spacing = pointSpacing(cloud->positions());
    const Skeleton pruned = withoutEveryThirdBranch(*Pipeline().run(cloud).skeleton);
    const Skeleton whole = together(pruned, grownFromUnexplained(pruned, cloud));
    const test::Course course = test::courseOf(whole, added(whole, pruned), *cloud);
    EXPECT_GT(course.nodes, 500U);
    EXPECT_LE(course.sharpestTurn, 120 + 1e-6);
    EXPECT_LE(course.farthestNode, 1.5 * spacing);
    EXPECT_LE(course.farthestOnEdge, 4 * spacing) << "no edge crosses a gap of over 6";
  }
}

// The trunk is an oval: over half of its bark is farther from its axis than its radius explains.
TEST(GrownFromUnexplained, GrowsNothingOnTheSkinOfThickWood) {
  Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.008);
  points.row(0) *= 1.3F;
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i <= 10; ++i)
    last = plant.add({.position = {0, 0, 0.2 * i}, .radius = 0.1, .parent = last});
  EXPECT_THROW((void)grownFromUnexplained(plant, scanOf(points)), Error);
  const Eigen::Matrix3Xf branch = test::cylinder({0.13, 0, 1}, {0.8, 0, 1.3}, 0.02, 0.008);
  const std::vector<GrownBranch> branches =
      grownFromUnexplained(plant, scanOf(test::both(points, branch)));
  const Skeleton whole = together(plant, branches);
  EXPECT_EQ(test::countTips(whole), 2);
  EXPECT_LT(farthestTip(whole, {0.8, 0, 1.3}), 0.08);
}

// Thousands of pieces in the air, and a branch of as many nodes: each is tried on each.
TEST(AttachedGrown, LeavesOutThousandsOfPiecesThatNothingLeadsToSoon) {
  const Eigen::Matrix3Xf branch = test::cylinder({0.04, 0, 1}, {20.05, 0, 1}, 0.02, 0.02);
  const auto cloud = scanOf(test::both(trunkPoints(), branch));
  Skeleton grown;
  std::optional<NodeId> last;
  for (int i = 0; i < 2000; ++i)
    last = grown.add({.position = {0.05 + 0.01 * i, 0, 1}, .radius = 0.01, .parent = last});
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3d place(i % 20, 50 + i / 20 % 20, i / 400);
    const NodeId foot = grown.add({.position = place});
    (void)grown.add({.position = place + Eigen::Vector3d(0, 0, 0.01), .parent = foot});
  }
  const std::vector<GrownBranch> branches =
      attached(trunk(), trunk().ids(), grown, *cloud,
               {.spacing = 0.02, .widestGap = 0.12, .widestJoin = 0.12});
  ASSERT_EQ(branches.size(), 1U);
  EXPECT_GT(branches[0].part.size(), 1900U);
  for (const NodeId id : branches[0].part.ids())
    EXPECT_LT(branches[0].part[id].position.y(), 1);
}

// Of the points of a short branch on a trunk, too few stand off the bark.
TEST(GrownFromUnexplained, GrowsNothingOfAStubOnTheBark) {
  const auto withBranchTo = [](double x) {
    return scanOf(
        test::both(trunkPoints(), test::cylinder({0.04, 0, 1}, {x, 0, 1.05}, 0.02, 0.02)));
  };
  EXPECT_THROW((void)grownFromUnexplained(trunk(), withBranchTo(0.12)), Error);
  EXPECT_EQ(grownFromUnexplained(trunk(), withBranchTo(0.28)).size(), 1U);
}

// One edge along all of the trunk: the branch begins amid it, and not at one of its ends.
TEST(GrownFromUnexplained, MakesANodeAmidALongEdge) {
  Skeleton plant;
  const NodeId foot = plant.add({.position = {0, 0, 0}, .radius = 0.04});
  const NodeId top = plant.add({.position = {0, 0, 2}, .radius = 0.04, .parent = foot});
  const Eigen::Matrix3Xf low = test::cylinder({0.04, 0, 0.6}, {0.8, 0, 0.9}, 0.02, 0.01);
  const Eigen::Matrix3Xf high = test::cylinder({-0.04, 0, 1.4}, {-0.8, 0, 1.7}, 0.02, 0.01);
  const auto cloud = scanOf(test::both(trunkPoints(), test::both(low, high)));
  const std::vector<GrownBranch> branches = grownFromUnexplained(plant, cloud);
  ASSERT_EQ(branches.size(), 2U);
  for (const GrownBranch& branch : branches)
    EXPECT_EQ(branch.on, top);
  const Skeleton whole = together(plant, branches);
  EXPECT_EQ(whole.roots().size(), 1U);
  const std::vector<NodeId> trunkAxis = axisThrough(whole, foot);
  ASSERT_EQ(trunkAxis.size(), 4U) << "with two new nodes";
  EXPECT_NEAR(whole[trunkAxis[1]].position.z(), 0.6, 0.1);
  EXPECT_NEAR(whole[trunkAxis[2]].position.z(), 1.4, 0.1);
  EXPECT_EQ(trunkAxis.back(), top);
}

// A twig of 46 points, as the check lists them: the pipeline made one node of such.
TEST(GrownBranches, MakeABranchOfFewPoints) {
  const Eigen::Matrix3Xf trunkAlone = trunkPoints();
  Eigen::Matrix3Xf twig(3, 46);
  for (int i = 0; i < 46; ++i) // 0.35 long, bent
    twig.col(i) = Eigen::Vector3f(0.06F + 0.0078F * float(i), 0.005F * float(i % 3),
                                  1 + 0.00015F * float(i * i));
  const auto cloud = scanOf(test::both(trunkAlone, twig));
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (cloud->fileOrder()[static_cast<std::size_t>(i)] >= trunkAlone.cols()) chosen.push_back(i);
  ASSERT_EQ(chosen.size(), 46U);
  const Skeleton whole = together(trunk(), grownBranches(trunk(), cloud, chosen));
  const std::vector<NodeId> ids = added(whole, trunk());
  EXPECT_GE(ids.size(), 2U);
  EXPECT_LE(ids.size(), 8U);
  EXPECT_LT(farthestTip(whole, twig.col(45).cast<double>()), 0.05);
  const test::Course course = test::courseOf(whole, ids, *cloud);
  EXPECT_LE(course.sharpestTurn, 120);
  EXPECT_LE(course.farthestNode, 1.5 * pointSpacing(cloud->positions()));
}

TEST(GrownBranches, GrowFromThePointsChosenAlone) {
  const Eigen::Matrix3Xf right = test::cylinder({0.04, 0, 0.8}, {0.8, 0, 1.2}, 0.02, 0.01);
  const Eigen::Matrix3Xf left = test::cylinder({-0.04, 0, 1.2}, {-0.8, 0, 1.6}, 0.02, 0.01);
  const auto cloud = scanOf(test::both(trunkPoints(), test::both(right, left)));
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
  const auto cloud = scanOf(test::both(trunkPoints(), branch));
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
  const auto cloud = scanOf(test::both(trunkPoints(), branch));
  const std::vector<GrownBranch> branches = grownBranches(
      trunk(), cloud, inside(*cloud, {Eigen::Vector3d(0.07, -1, 0), Eigen::Vector3d(1, 1, 2)}));
  ASSERT_EQ(branches.size(), 1U);
  EXPECT_NEAR(trunk()[branches[0].on].position.z(), 0.6, 1e-9);
}

TEST(GrownBranches, AreRefusedForTooFewPoints) {
  const auto cloud = scanOf(trunkPoints());
  EXPECT_THROW((void)grownBranches(trunk(), cloud, {0, 1, 2}), Error);
  EXPECT_THROW((void)grownBranches(trunk(), cloud, {}), Error);
  EXPECT_THROW((void)grownFromUnexplained(trunk(), cloud, {.tolerance = 0.1}), Error)
      << "all are explained";
}

TEST(GrownBranches, StopWhenAsked) {
  const auto cloud =
      scanOf(test::both(trunkPoints(), test::cylinder({0.04, 0, 1}, {0.8, 0, 1.2}, 0.02, 0.01)));
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)grownFromUnexplained(trunk(), cloud, {}, progress); }));
}

} // namespace
} // namespace espalier
