#include "core/base/error.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/pipeline/grow_part.h"
#include "core/pipeline/regrow.h"
#include "core/skeleton/assign_points.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/select.h"
#include "tests/support/clouds.h"
#include "tests/support/simulated.h"
#include "tests/support/surface_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// What `node` carries, as a plant of its own.
Skeleton carriedBy(const Skeleton& skeleton, NodeId node) {
  Skeleton part;
  std::vector<NodeId> copies(skeleton.idEnd());
  for (const NodeId id : downstream(skeleton, {node})) {
    Node copy = skeleton[id];
    copy.parent = id == node ? std::nullopt : std::optional(copies[indexOf(*copy.parent)]);
    copies[indexOf(id)] = part.add(copy);
  }
  return part;
}

Skeleton without(Skeleton skeleton, NodeId child) {
  SkeletonEditor editor(skeleton);
  removeSubtree(editor, child);
  (void)editor.commit();
  return skeleton;
}

/// The branching node of the trunk, not the lowest, whose side branch carries most.
NodeId foot(const Skeleton& skeleton) {
  NodeId best = skeleton.roots().front();
  std::size_t most = 0;
  for (const NodeId id : skeleton.ids())
    if (skeleton[id].parent && skeleton[id].edge == EdgeType::branching) {
      const std::size_t count = downstream(skeleton, {id}).size();
      if (count > most) {
        most = count;
        best = id;
      }
    }
  return best;
}

double lengthShareFound(const Skeleton& result, const Skeleton& truth, double distance) {
  return toleranceCurve(result, truth, {.distances = {distance}}).scores.front().f();
}

// The lowest node of a side branch keeps its place; all that it carries is taken away.
TEST(Regrow, BringsBackASubtreeAsWellAsAWholeReconstructionDoes) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const auto cloud = std::make_shared<const PointCloud>(tree.cloud);
  const NodeId branch = foot(tree.truth);
  const Skeleton lost = carriedBy(tree.truth, branch);
  Skeleton pruned = tree.truth;
  for (const NodeId child : tree.truth.children(branch))
    pruned = without(std::move(pruned), child);

  const Skeleton whole = *Pipeline().run(cloud).skeleton;
  const double distance = 3 * pointSpacing(cloud->positions());
  const double reached = lengthShareFound(whole, tree.truth, distance);
  const Skeleton grown = regrown(pruned, branch, cloud);
  EXPECT_GT(grown.size(), 5U);
  EXPECT_GT(lengthShareFound(grown, lost, distance), reached - 0.1);
  EXPECT_EQ(grown[grown.roots().front()].position, tree.truth[branch].position);
}

TEST(Regrow, ReplacesASubtreeByTheSameAsIfItWereGone) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const auto cloud = std::make_shared<const PointCloud>(tree.cloud);
  const NodeId branch = foot(tree.truth);
  const Skeleton lost = carriedBy(tree.truth, branch);
  const Skeleton grown = regrown(tree.truth, branch, cloud);
  const double distance = 3 * pointSpacing(cloud->positions());
  EXPECT_GT(lengthShareFound(grown, lost, distance), 0.6);
}

TEST(Regrow, LeavesTheRestToTheBit) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const NodeId branch = foot(tree.truth);
  const Skeleton grown =
      regrown(tree.truth, branch, std::make_shared<const PointCloud>(tree.cloud));
  Skeleton after = tree.truth;
  SkeletonEditor editor(after);
  replaceCarried(editor, branch, grown);
  (void)editor.commit();
  std::vector<bool> isCarried(tree.truth.idEnd(), false);
  for (const NodeId id : downstream(tree.truth, {branch}))
    isCarried[indexOf(id)] = true;
  for (const NodeId id : tree.truth.ids())
    if (!isCarried[indexOf(id)] || id == branch) {
      ASSERT_TRUE(after.contains(id));
      EXPECT_EQ(after[id], tree.truth[id]);
    }
}

TEST(Regrow, GrowsNothingThickerThanItsNode) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const NodeId branch = foot(tree.truth);
  const Skeleton grown =
      regrown(tree.truth, branch, std::make_shared<const PointCloud>(tree.cloud));
  for (const NodeId id : grown.ids())
    EXPECT_LE(grown[id].radius, tree.truth[branch].radius);
}

std::shared_ptr<const PointCloud> forkCloud() {
  RawPoints raw;
  const Eigen::Matrix3Xf points = test::forkCloud();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>());
  return std::make_shared<const PointCloud>(std::move(raw));
}

// Its tip bends: two nodes follow that. What grows has no fewer, and follows the points no worse.
TEST(Regrow, FollowsABendNearATip) {
  RawPoints raw;
  const auto curve = [](double along) {
    return Eigen::Vector3d(0.3 * along * along, 0, 1 + along);
  };
  for (int i = 0; i < 200; ++i)
    raw.positions.emplace_back(0.006 * std::cos(2.4 * i), 0.006 * std::sin(2.4 * i), i / 200.0);
  for (int i = 0; i < 60; ++i)
    raw.positions.emplace_back(curve(i / 120.0) +
                               0.004 * Eigen::Vector3d(std::cos(2.4 * i), std::sin(2.4 * i), 0));
  const auto cloud = std::make_shared<const PointCloud>(std::move(raw));
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i <= 5; ++i)
    last = plant.add({.position = {0, 0, 0.2 * i}, .radius = 0.006, .parent = last});
  const NodeId node = *last;
  for (const double along : {0.17, 0.34, 0.5})
    last = plant.add({.position = curve(along), .radius = 0.004, .parent = last});
  const Skeleton before = carriedBy(plant, node);
  const Skeleton grown = regrown(plant, node, cloud);
  EXPECT_GE(grown.size(), before.size());
  const auto mean = [&](const Skeleton& part) {
    double sum = 0;
    for (int i = 0; i < 50; ++i) {
      const Eigen::Matrix3Xf place = curve(i / 100.0).cast<float>();
      sum += assignPoints(place, Eigen::Vector3d::Zero(), part).front().distance / 50;
    }
    return sum;
  };
  EXPECT_LE(mean(grown), mean(before) + 0.002) << "half the radius of the twig";
}

TEST(Regrow, TracesFromEndToEndOrFromThePlaceThatIsGiven) {
  RawPoints raw;
  std::vector<Eigen::Index> all;
  for (int i = 0; i < 300; ++i) {
    raw.positions.emplace_back(0.006 * std::cos(2.4 * i), 0.006 * std::sin(2.4 * i), i / 200.0);
    all.push_back(i);
  }
  const PointCloud cloud(std::move(raw));
  const Eigen::Vector3d place(0, 0, 0.4);
  const auto lowest = [](const Skeleton& tree) {
    const std::vector<NodeId> ids = tree.ids();
    return std::ranges::min(ids, {}, [&](NodeId id) { return tree[id].position.z(); });
  };
  const Skeleton whole = treeAlong(cloud, all, place, 0.1, TracedFrom::end);
  EXPECT_NEAR(whole[whole.roots().front()].position.z(), 1.5, 0.02) << "the end farthest from it";
  EXPECT_LT(whole[lowest(whole)].position.z(), 0.02);
  EXPECT_EQ(whole.children(whole.roots().front()).size(), 1U);
  const Skeleton both = treeAlong(cloud, all, place, 0.1, TracedFrom::start);
  EXPECT_NEAR((both[both.roots().front()].position - place).norm(), 0, 0.01);
  EXPECT_EQ(both.children(both.roots().front()).size(), 2U) << "up, and back to the other end";
  EXPECT_LT(both[lowest(both)].position.z(), 0.02);
}

TEST(Regrow, FindsBothArmsAboveATrunk) {
  Skeleton trunk;
  const NodeId root = trunk.add({.position = {0, 0, 0}, .radius = 0.04});
  const NodeId top = trunk.add({.position = {0, 0, 1.9}, .radius = 0.04, .parent = root});
  const Skeleton grown = regrown(trunk, top, forkCloud());
  EXPECT_LT(test::farthestFromFork(grown), 0.08);
  const auto isTip = [&](NodeId id) { return grown.children(id).empty(); };
  const std::vector<NodeId> ids = grown.ids();
  EXPECT_EQ(std::ranges::count_if(ids, isTip), 2);
}

// Wood that carries it hides the foot of a branch from the scanner.
TEST(Regrow, BeginsAcrossWhatIsHiddenBesideThickWood) {
  Skeleton trunk;
  NodeId top = trunk.add({.position = {0, 0, 0}, .radius = 0.1});
  for (int i = 1; i <= 20; ++i)
    top = trunk.add({.position = {0, 0, 0.05 * i}, .radius = 0.1, .parent = top});
  Skeleton arm;
  const NodeId low = arm.add({.position = {0, 0, 1.25}, .radius = 0.02});
  arm.add({.position = {0, 0, 1.8}, .radius = 0.02, .parent = low});
  RawPoints points = sampleSurface(trunk, {.spacing = 0.01}, 1).points;
  const RawPoints ofArm = sampleSurface(arm, {.spacing = 0.01}, 2).points;
  points.positions.insert(points.positions.end(), ofArm.positions.begin(), ofArm.positions.end());
  const Skeleton grown = regrown(trunk, top, std::make_shared<const PointCloud>(std::move(points)));
  double highest = 0;
  for (const NodeId id : grown.ids())
    highest = std::max(highest, grown[id].position.z());
  EXPECT_NEAR(highest, 1.8, 0.1);
}

// Points that noise moves off the trunk are connected with those of the branch.
TEST(Regrow, GrowsTheBranchAloneInAScanWithWideNoise) {
  Skeleton plant;
  NodeId trunk = plant.add({.position = {0, 0, 0}, .radius = 0.03});
  NodeId bearer = trunk;
  for (int i = 1; i <= 20; ++i) {
    trunk = plant.add({.position = {0, 0, 0.1 * i}, .radius = 0.03, .parent = trunk});
    if (i == 10) bearer = trunk;
  }
  NodeId foot = plant.add(
      {.position = {0.1, 0, 1.05}, .radius = 0.02, .parent = bearer, .edge = EdgeType::branching});
  const NodeId first = foot;
  for (int i = 1; i <= 8; ++i)
    foot = plant.add(
        {.position = {0.1 + 0.08 * i, 0, 1.05 + 0.05 * i}, .radius = 0.02, .parent = foot});
  const auto cloud = std::make_shared<const PointCloud>(
      sampleSurface(plant, {.points = 20'000, .noise = 0.015}, 5).points);
  const Skeleton grown = regrown(without(plant, plant.children(first).front()), first, cloud);
  double length = 0;
  for (const NodeId id : grown.ids()) {
    EXPECT_GT(grown[id].position.x(), 0) << "the trunk has its wood";
    length += grown[id].parent ? edgeLength(grown, id) : 0;
  }
  EXPECT_NEAR(length, 8 * std::hypot(0.08, 0.05), 0.25);
}

TEST(Regrow, IsRefusedWhereThePlantExplainsAllPoints) {
  const Skeleton plant = *Pipeline().run(forkCloud()).skeleton;
  const std::vector<NodeId> ids = plant.ids();
  const NodeId tip =
      *std::ranges::find_if(ids, [&](NodeId id) { return plant.children(id).empty(); });
  EXPECT_THROW((void)regrown(plant, tip, forkCloud(), {.tolerance = 0.1}), Error);
}

TEST(Regrow, StopsWhenAsked) {
  const Skeleton plant = *Pipeline().run(forkCloud()).skeleton;
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)regrown(plant, plant.roots().front(), forkCloud(), {}, progress);
  }));
}

} // namespace
} // namespace espalier
