#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/skeleton_delta.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double spacing = 0.02; // [L]
constexpr double radius = 0.04;  // [L], of all wood here

using Cloud = std::shared_ptr<const PointCloud>;

std::vector<Finding> found(const Cloud& cloud, const Skeleton& skeleton,
                           const CheckOptions& options = {}) {
  const PointDistances distances(cloud, spacing, skeleton);
  const SpatialIndex index(cloud->positions());
  return branchesWithoutOwnPoints(skeleton, distances, index, spacing, options);
}

/// Two trunks of height 1, 0.2 apart, with points all over them: 7 spacings between their wood.
Eigen::Matrix3Xf trunkPoints() {
  return test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, radius, spacing),
                    test::cylinder({0.2, 0, 0}, {0.2, 0, 1}, radius, spacing));
}

const NodeId leftMiddle{1};
const NodeId rightMiddle{4};

/// Nodes 0 to 2 up the left one, 3 to 5 up the right one.
Skeleton trunks() {
  Skeleton plant;
  for (const double x : {0.0, 0.2}) {
    std::optional<NodeId> parent;
    for (const double z : {0.0, 0.5, 1.0})
      parent = plant.add({.position = {x, 0, z}, .radius = radius, .parent = parent});
  }
  return plant;
}

NodeId addBranch(Skeleton& plant, NodeId parent, const Eigen::Vector3d& to,
                 EdgeType edge = EdgeType::branching) {
  return plant.add({.position = to, .radius = 0.01, .parent = parent, .edge = edge});
}

// Halfway to the other trunk: everywhere are points within 4 spacings, and all belong to trunks.
TEST(OwnPoints, AreNotThoseOfWoodBesideASpur) {
  Skeleton plant = trunks();
  const NodeId spur = addBranch(plant, leftMiddle, {0.1, 0, 0.5});
  const NodeId tip = addBranch(plant, spur, {0.1, 0, 0.7}, EdgeType::successor);
  const Cloud cloud = test::cloudAtOrigin(trunkPoints());
  const SpatialIndex index(cloud->positions());
  EXPECT_THAT(edgesWithoutPoints(plant, *cloud, index, spacing, {}), IsEmpty());
  const std::vector<Finding> findings = found(cloud, plant);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].kind, Finding::Kind::noOwnPoints);
  EXPECT_EQ(findings[0].node, spur);
  EXPECT_THAT(findings[0].others, ElementsAre(tip));
  // 0.2 up, and what of its beginning is over 2 spacings from the trunk, to a step of a spacing
  EXPECT_NEAR(findings[0].amount, 0.2 + 0.1 - radius - 2 * spacing, spacing);
  EXPECT_THAT(
      describe(findings[0], plant),
      testing::StartsWith("the branch at node 6 has no points of its own along its first 0.2"));
}

TEST(OwnPoints, AreThoseOfATrueShoot) {
  Skeleton plant = trunks();
  addBranch(plant, leftMiddle, {0, 0.2, 0.6});
  const Eigen::Matrix3Xf shoot = test::cylinder({0, 0, 0.5}, {0, 0.2, 0.6}, 0.01, spacing);
  EXPECT_THAT(found(test::cloudAtOrigin(test::both(trunkPoints(), shoot)), plant), IsEmpty());
  EXPECT_THAT(found(test::cloudAtOrigin(trunkPoints()), plant), SizeIs(1)) << "without its points";
}

// Its beginning is at the other trunk, to which it leads across the gap.
TEST(OwnPoints, BeginLateWhereABranchIsAttachedToTheWrongWood) {
  Skeleton plant = trunks();
  const NodeId branch = addBranch(plant, rightMiddle, {0.2, 0.2, 0.5});
  const NodeId tip = addBranch(plant, branch, {0.2, 0.4, 0.5}, EdgeType::successor);
  const Eigen::Matrix3Xf wood = test::cylinder({0.2, 0, 0.5}, {0.2, 0.4, 0.5}, 0.01, spacing);
  const Cloud cloud = test::cloudAtOrigin(test::both(trunkPoints(), wood));
  EXPECT_THAT(found(cloud, plant), IsEmpty());
  plant.reparent(branch, leftMiddle, EdgeType::branching);
  const std::vector<Finding> findings = found(cloud, plant);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].node, branch);
  EXPECT_THAT(findings[0].others, testing::Not(testing::Contains(tip)));
  EXPECT_LT(findings[0].amount, 0.2 * std::sqrt(2.0));
}

TEST(OwnPoints, AreNotAskedForInsideOtherWood) {
  Skeleton plant = trunks();
  addBranch(plant, leftMiddle, {radius + 2 * spacing - 1e-3, 0, 0.5}); // a bud
  EXPECT_THAT(found(test::cloudAtOrigin(trunkPoints()), plant), IsEmpty());
}

TEST(OwnPoints, AreMoreThanStrays) {
  Skeleton plant = trunks();
  addBranch(plant, leftMiddle, {0, 0.2, 0.5});
  for (const int strays : {2, 3}) {
    Eigen::Matrix3Xf points(3, strays); // within reach of all of the branch
    for (int i = 0; i < strays; ++i)
      points.col(i) << 0, 0.13F + 0.001F * static_cast<float>(i), 0.505F;
    const Cloud cloud = test::cloudAtOrigin(test::both(trunkPoints(), points));
    EXPECT_THAT(found(cloud, plant, {.ownLength = 4}), SizeIs(strays < 3 ? 1 : 0)) << strays;
  }
}

TEST(OwnPoints, AreFoundAboutAllBranchesOfAPlantThatIsSeenFromAllSides) {
  const test::SimulatedPlant& herb = test::simulatedHerb();
  const auto cloud = std::make_shared<const PointCloud>(herb.cloud);
  const double apart = pointSpacing(cloud->positions());
  const PointDistances distances(cloud, apart, herb.truth);
  const SpatialIndex index(cloud->positions());
  EXPECT_THAT(branchesWithoutOwnPoints(herb.truth, distances, index, apart, {}), IsEmpty());
}

TEST(OwnPoints, AreMissedNowhereWithoutAScanOrBranches) {
  EXPECT_THAT(found(test::cloudAtOrigin(trunkPoints()), {}), IsEmpty());
  EXPECT_THAT(found(test::cloudAtOrigin(trunkPoints()), trunks()), IsEmpty());
  Skeleton plant = trunks();
  addBranch(plant, leftMiddle, {0, 0.2, 0.5});
  EXPECT_THAT(found(std::make_shared<const PointCloud>(), plant), IsEmpty());
}

TEST(OwnPoints, AreMissedAlikeWhereverThePlantStands) {
  Skeleton plant = trunks();
  addBranch(plant, leftMiddle, {0, 0.2, 0.5});
  const std::vector<Finding> before = found(test::cloudAtOrigin(trunkPoints()), plant);
  const Eigen::Vector3d away(100, -50, 7);
  Eigen::Matrix3Xf moved = trunkPoints();
  moved.colwise() += away.cast<float>();
  for (const NodeId id : plant.ids())
    plant.setPosition(id, plant[id].position + away);
  const std::vector<Finding> after = found(test::cloudAtOrigin(moved), plant);
  ASSERT_THAT(after, SizeIs(1));
  ASSERT_THAT(before, SizeIs(1));
  EXPECT_EQ(after[0].node, before[0].node);
  EXPECT_NEAR(after[0].amount, before[0].amount, spacing) << "points are floats";
}

TEST(OwnPoints, AreLookedForUntilOneIsAskedToStop) {
  Skeleton plant = trunks();
  addBranch(plant, leftMiddle, {0, 0.2, 0.5});
  const Cloud cloud = test::cloudAtOrigin(trunkPoints());
  const PointDistances distances(cloud, spacing, plant);
  const SpatialIndex index(cloud->positions());
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(branchesWithoutOwnPoints(plant, distances, index, spacing, {}, progress));
  }));
}

} // namespace
} // namespace espalier
