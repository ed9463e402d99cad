#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/select.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::IsEmpty;
using testing::SizeIs;
using Kind = Finding::Kind;

std::vector<Finding> clustersIn(const std::shared_ptr<const PointCloud>& cloud,
                                const Skeleton& skeleton, const CheckOptions& options = {}) {
  const double spacing = pointSpacing(cloud->positions());
  return unexplainedClusters(PointDistances(cloud, spacing, skeleton), spacing, options);
}

std::vector<Finding> emptyEdges(const PointCloud& cloud, const Skeleton& skeleton,
                                const CheckOptions& options = {}) {
  return edgesWithoutPoints(skeleton, cloud, SpatialIndex(cloud.positions()),
                            pointSpacing(cloud.positions()), options);
}

/// A trunk of radius 0.1 and height 2 with points all over it, and its skeleton.
const Eigen::Vector3d trunkTop(0, 0, 2);
std::shared_ptr<const PointCloud> trunkCloud() {
  return test::cloudAtOrigin(test::cylinder(Eigen::Vector3d::Zero(), trunkTop, 0.1, 0.02));
}

/// The plant without what a node carries, itself included.
Skeleton without(Skeleton plant, NodeId branch) {
  const std::vector<NodeId> carried = downstream(plant, {branch});
  const std::vector<NodeId> ids = plant.ids();
  for (auto id = ids.rbegin(); id != ids.rend(); ++id)
    if (std::ranges::find(carried, *id) != carried.end()) plant.erase(*id);
  return plant;
}

/// The first node of the branch that carries the most.
NodeId largestBranch(const Skeleton& plant) {
  NodeId largest{};
  std::size_t most = 0;
  for (const NodeId id : plant.ids()) {
    if (!plant[id].parent || plant[id].edge != EdgeType::branching) continue;
    const std::size_t carried = downstream(plant, {id}).size();
    if (carried > most) largest = id;
    most = std::max(most, carried);
  }
  return largest;
}

TEST(ChecksOfScan, FindNothingWhereAllIsExplained) {
  const test::SimulatedPlant& herb = test::simulatedHerb();
  const auto cloud = std::make_shared<const PointCloud>(herb.cloud);
  EXPECT_THAT(clustersIn(cloud, herb.truth), IsEmpty());
  EXPECT_THAT(emptyEdges(*cloud, herb.truth), IsEmpty());
}

// Its scan has errors and strays. (What no station saw has no points, and is reported.)
TEST(ChecksOfScan, FindNoUnexplainedPointsInTheScanOfATree) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  EXPECT_THAT(clustersIn(std::make_shared<const PointCloud>(tree.cloud), tree.truth), IsEmpty());
}

TEST(UnexplainedClusters, AreWhereABranchIsMissing) {
  const test::SimulatedPlant& herb = test::simulatedHerb();
  const auto cloud = std::make_shared<const PointCloud>(herb.cloud);
  const NodeId branch = largestBranch(herb.truth);
  const std::vector<NodeId> carried = downstream(herb.truth, {branch});
  const std::vector<Finding> found = clustersIn(cloud, without(herb.truth, branch));
  ASSERT_THAT(found, testing::Not(IsEmpty()));
  double nearest = 1e9;
  double longest = 0;
  for (const NodeId id : carried) {
    nearest = std::min(nearest, (herb.truth[id].position - found[0].place).norm());
    longest = std::max(longest, (herb.truth[id].position - herb.truth[branch].position).norm());
  }
  EXPECT_LT(nearest, longest);
}

// 50 points on a line, 1 to the right of the trunk's surface; gaps of 0.01.
TEST(UnexplainedClusters, StateTheirSizeAndPlace) {
  Eigen::Matrix3Xf line(3, 50);
  for (int i = 0; i < 50; ++i)
    line.col(i) << 1.1F, 0, 1 + 0.01F * static_cast<float>(i - 24.5);
  const auto cloud = test::cloudAtOrigin(
      test::both(test::cylinder(Eigen::Vector3d::Zero(), trunkTop, 0.1, 0.02), line));
  const Skeleton trunk = test::stick(3);
  const std::vector<Finding> found = clustersIn(cloud, trunk);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].amount, 50);
  EXPECT_THAT(found[0].points, SizeIs(50));
  EXPECT_TRUE(std::ranges::is_sorted(found[0].points));
  for (const Eigen::Index point : found[0].points)
    EXPECT_NEAR(cloud->position(point).x(), 1.1, 1e-4);
  EXPECT_LT((found[0].place - Eigen::Vector3d(1.1, 0, 1)).norm(), 1e-4);
  EXPECT_NEAR(found[0].reach, 0.245, 1e-4);
  EXPECT_EQ(describe(found[0], trunk), "50 points near node " +
                                           std::to_string(indexOf(found[0].node)) +
                                           " are far from any edge");
  EXPECT_TRUE(boundsOf(found[0], trunk).contains(Eigen::Vector3d(1.1, 0, 1.2)));
  EXPECT_THAT(clustersIn(cloud, trunk, {.clusterSize = 51}), IsEmpty());
  EXPECT_THAT(clustersIn(cloud, trunk, {.pointReach = 1000}), IsEmpty());
}

// 10 places off the trunk are no cluster, however often each is there.
TEST(UnexplainedClusters, CountEachPlaceOnce) {
  Eigen::Matrix3Xf line(3, 200);
  for (int i = 0; i < 200; ++i)
    line.col(i) << 1.1F, 0, 1 + 0.01F * static_cast<float>(i / 20);
  const auto cloud = test::cloudAtOrigin(
      test::both(test::cylinder(Eigen::Vector3d::Zero(), trunkTop, 0.1, 0.02), line));
  EXPECT_THAT(clustersIn(cloud, test::stick(3)), IsEmpty());
  EXPECT_THAT(clustersIn(cloud, test::stick(3), {.clusterSize = 10}), SizeIs(1));
}

TEST(UnexplainedClusters, AreNoneWithoutNodesOrPoints) {
  EXPECT_THAT(clustersIn(trunkCloud(), {}), IsEmpty());
  EXPECT_THAT(clustersIn(std::make_shared<const PointCloud>(), test::stick(3)), IsEmpty());
}

TEST(EdgesWithoutPoints, AreTheSpurThatIsNotThere) {
  Skeleton plant = test::stick(3);
  const NodeId spur = plant.add(
      {.position = {1, 0, 1}, .radius = 0.05, .parent = NodeId{1}, .edge = EdgeType::branching});
  const NodeId tip = plant.add({.position = {1, 0, 2}, .radius = 0.05, .parent = spur});
  const NodeId end = plant.add({.position = {1, 0, 2.5}, .radius = 0.05, .parent = tip});
  const std::vector<Finding> found = emptyEdges(*trunkCloud(), plant);
  ASSERT_THAT(found, SizeIs(1)); // points of the trunk are near its first quarter only
  EXPECT_EQ(found[0].node, spur);
  EXPECT_THAT(found[0].others, testing::ElementsAre(tip, end));
  EXPECT_NEAR(found[0].amount, 2.5, 1e-12);
  EXPECT_EQ(describe(found[0], plant), "2.5 from node 3 on are far from any point");
}

TEST(EdgesWithoutPoints, AreNoneThatAreNearEnough) {
  Skeleton plant = test::stick(3);
  plant.add({.position = {0.3, 0, 1.9}, .radius = 0.05, .parent = NodeId{2}});
  EXPECT_THAT(emptyEdges(*trunkCloud(), plant), IsEmpty());
  EXPECT_THAT(emptyEdges(PointCloud(), plant), IsEmpty());
  EXPECT_THAT(emptyEdges(*trunkCloud(), {}), IsEmpty());
}

TEST(ChecksOfScan, StopWhenAsked) {
  const auto cloud = trunkCloud();
  const Skeleton far = test::stick(1);
  const PointDistances distances(cloud, 0.02, far);
  const SpatialIndex index(cloud->positions());
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(unexplainedClusters(distances, 0.02, {}, progress));
  }));
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(edgesWithoutPoints(test::stick(3), *cloud, index, 0.02, {}, progress));
  }));
}

} // namespace
} // namespace espalier
