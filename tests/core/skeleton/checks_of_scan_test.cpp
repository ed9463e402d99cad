#include "core/base/random.h"
#include "core/skeleton/beside_points.h"
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
#include <numbers>

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
  EXPECT_EQ(describe(found[0], trunk),
            "bare twig, 50 points, 0.49 long, near node " + std::to_string(indexOf(found[0].node)));
  EXPECT_TRUE(boundsOf(found[0], trunk).contains(Eigen::Vector3d(1.1, 0, 1.2)));
  EXPECT_THAT(clustersIn(cloud, trunk, {.clusterSize = 51}), IsEmpty());
  EXPECT_THAT(clustersIn(cloud, trunk, {.pointReach = 1000}), IsEmpty());
}

// 5 places off the trunk are no cluster, however often each is there.
TEST(UnexplainedClusters, CountEachPlaceOnce) {
  Eigen::Matrix3Xf line(3, 200);
  for (int i = 0; i < 200; ++i)
    line.col(i) << 1.1F, 0, 1 + 0.01F * static_cast<float>(i / 40);
  const auto cloud = test::cloudAtOrigin(
      test::both(test::cylinder(Eigen::Vector3d::Zero(), trunkTop, 0.1, 0.02), line));
  EXPECT_THAT(clustersIn(cloud, test::stick(3)), IsEmpty());
  EXPECT_THAT(clustersIn(cloud, test::stick(3), {.clusterSize = 5}), SizeIs(1));
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

/// `count` points in a row, `step` apart, that begins at `from` and goes to the right.
Eigen::Matrix3Xf row(const Eigen::Vector3f& from, int count, float step) {
  Eigen::Matrix3Xf points(3, count);
  for (int i = 0; i < count; ++i)
    points.col(i) = from + Eigen::Vector3f(step * static_cast<float>(i), 0, 0);
  return points;
}

std::vector<Finding> allOf(const std::shared_ptr<const PointCloud>& cloud, const Skeleton& skeleton,
                           const CheckOptions& options = {}) {
  const double spacing = pointSpacing(cloud->positions());
  return checkAgainstScan(skeleton, PointDistances(cloud, spacing, skeleton),
                          SpatialIndex(cloud->positions()), spacing, options);
}

const Eigen::Matrix3Xf trunkPoints = test::cylinder(Eigen::Vector3d::Zero(), trunkTop, 0.1, 0.02);

TEST(UnexplainedClusters, AreBareTwigsOfFewPointsButNoFuzz) {
  const Skeleton trunk = test::stick(3);
  const Eigen::Matrix3Xf twig = row({0.17F, 0, 1}, 8, 0.02F); // to 8 spacings from the wood
  const std::vector<Finding> found =
      clustersIn(test::cloudAtOrigin(test::both(trunkPoints, twig)), trunk);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].amount, 8);
  EXPECT_EQ(describe(found[0], trunk).substr(0, 26), "bare twig, 8 points, 0.14 ");
  const Eigen::Matrix3Xf fuzz = row({0.145F, 0, 1}, 8, 0.003F); // to 5 spacings
  EXPECT_THAT(clustersIn(test::cloudAtOrigin(test::both(trunkPoints, fuzz)), trunk), IsEmpty());
}

TEST(Exactness, IsTheSpacingOrHowFarPointsAreOffTheWood) {
  const auto cloud = test::cloudAtOrigin(trunkPoints);
  const auto of = [&](double radius) {
    Skeleton plant = test::stick(3);
    for (const NodeId id : plant.ids())
      plant.setRadius(id, radius);
    return exactness(PointDistances(cloud, 0.02, plant), 0.02, {});
  };
  EXPECT_NEAR(of(0.1), 0.02, 1e-9);
  EXPECT_NEAR(of(0.076), 0.032, 1e-5);
  EXPECT_NEAR(of(0.01), 0.04, 1e-9) << "at most twice as much: else nothing were missing";
}

// How many points there would be is known by the other wood, however little that is.
TEST(EdgesWithoutPoints, AreFoundWhereTheyAreLongerThanAllElse) {
  Skeleton plant = test::stick(9, 0.25);
  const NodeId far = plant.add({.position = {0.5, 0, -9}, .radius = 0.1});
  plant.reparent(NodeId{0}, far, EdgeType::successor);
  const std::vector<Finding> found = allOf(trunkCloud(), plant);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::edgesWithoutPoints);
  EXPECT_EQ(found[0].node, NodeId{0});
}

TEST(BesidePoints, IsAStemThatWasMovedAside) {
  const auto cloud = test::cloudAtOrigin(trunkPoints);
  const auto moved = [](double shift) {
    Skeleton plant = test::stick(9, 0.25);
    for (const int i : {3, 4, 5})
      plant.setPosition(NodeId(i), plant[NodeId(i)].position + Eigen::Vector3d(shift, 0, 0));
    return plant;
  };
  EXPECT_THAT(allOf(cloud, moved(0)), IsEmpty());
  EXPECT_THAT(allOf(cloud, moved(0.03)), IsEmpty()) << "under half a radius";
  const std::vector<Finding> found = allOf(cloud, moved(0.12));
  ASSERT_THAT(found, SizeIs(1)) << "its points are not reported once more";
  EXPECT_EQ(found[0].kind, Kind::besidePoints);
  EXPECT_THAT(nodesOf(found[0]), testing::IsSupersetOf({NodeId{3}, NodeId{4}, NodeId{5}}));
  EXPECT_NEAR(found[0].amount, 0.12, 0.01);
}

// The points of the top of the bow are nearer to its flanks than to its top.
TEST(BesidePoints, IsAThinTwigThatBowsAsideAndBackOnAShortWay) {
  Random random(3);
  Eigen::Matrix3Xf points(3, 61); // one per spacing
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) = (Eigen::Vector3d(0, 0, double(i)) + 0.3 * random.direction()).cast<float>();
  const auto cloud = test::cloudAtOrigin(points);
  const auto bowed = [](double height) {
    Skeleton plant = test::stick(61, 1);
    constexpr double half = 8;
    for (const NodeId id : plant.ids()) {
      Eigen::Vector3d place = plant[id].position;
      const double from = std::abs(place.z() - 30) / half;
      if (from < 1) place.x() = height * (0.5 + 0.5 * std::cos(std::numbers::pi * from));
      plant.setPosition(id, place);
      plant.setRadius(id, 0.3);
    }
    return plant;
  };
  const auto beside = [&](double height) {
    const Skeleton plant = bowed(height);
    return axesBesidePoints(plant, PointDistances(cloud, 1, plant), 1, 1, {});
  };
  EXPECT_THAT(beside(0), IsEmpty());
  EXPECT_THAT(beside(2), IsEmpty()) << "under 2.5 spacings";
  const std::vector<Finding> found = beside(5);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(nodesOf(found[0]), testing::Contains(NodeId{30}));
  EXPECT_NEAR(found[0].amount, 4, 1);
}

// Half of the trunk has points: how far it is to be moved is known across them all the same.
TEST(BesidePoints, AreToldFromOneSideToo) {
  Eigen::Matrix3Xf half = trunkPoints;
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < half.cols(); ++i)
    if (half(0, i) > 0) half.col(kept++) = half.col(i);
  half.conservativeResize(3, kept);
  Skeleton plant = test::stick(9, 0.25);
  EXPECT_THAT(allOf(test::cloudAtOrigin(half), plant), IsEmpty());
  for (const NodeId id : plant.ids())
    plant.setPosition(id, plant[id].position - Eigen::Vector3d(0.12, 0, 0));
  const std::vector<Finding> found = allOf(test::cloudAtOrigin(half), plant);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, Kind::besidePoints);
  EXPECT_NEAR(found[0].amount, 0.12, 0.02);
}

TEST(ShortFoot, IsWhereThePointsOfAStemGoOnBelowItsRoot) {
  Skeleton plant = test::stick(9, 0.25);
  const auto cloud = test::cloudAtOrigin(trunkPoints);
  EXPECT_THAT(allOf(cloud, plant), IsEmpty());
  plant.setPosition(NodeId{0}, {0, 0, 0.22});
  const std::vector<Finding> found = allOf(cloud, plant);
  ASSERT_THAT(found, SizeIs(1)) << "its points are not reported once more";
  EXPECT_EQ(found[0].kind, Kind::shortFoot);
  EXPECT_EQ(found[0].node, NodeId{0});
  EXPECT_NEAR(found[0].amount, 0.22, 1e-3);
  EXPECT_FALSE(found[0].points.empty());
  plant.setPosition(NodeId{0}, {0, 0, 0.1});
  EXPECT_THAT(allOf(cloud, plant), IsEmpty()) << "under 6 spacings";
}

/// A branch to the right of which points are seen up to x = 1.1 and from x = 1.6 on; its end is at
/// x = 2.1.
TEST(EdgesWithoutPoints, AreNotReportedWhereWoodGoesOnBehindWhatHidIt) {
  const Eigen::Vector3d hidden(1.1, 0, 1);
  const Eigen::Matrix3Xf branch = test::both(test::cylinder({0, 0, 1}, hidden, 0.03, 0.02),
                                             test::cylinder({1.6, 0, 1}, {2.1, 0, 1}, 0.03, 0.02));
  const auto cloud = test::cloudAtOrigin(test::both(trunkPoints, branch));
  const auto leading = [&](double aside) {
    Skeleton plant = test::stick(3);
    NodeId last = plant.add(
        {.position = hidden, .radius = 0.03, .parent = NodeId{1}, .edge = EdgeType::branching});
    for (const double x : {1.6, 2.1})
      last = plant.add({.position = {x, x < 2 ? aside : 0, 1}, .radius = 0.03, .parent = last});
    return plant;
  };
  EXPECT_THAT(allOf(cloud, leading(0)), IsEmpty());
  EXPECT_THAT(allOf(cloud, leading(0), {.hiddenTurn = -1}), SizeIs(1)) << "all is reported";
  EXPECT_THAT(allOf(cloud, leading(0.6)), testing::Not(IsEmpty())) << "it turns by 50 degrees";
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
