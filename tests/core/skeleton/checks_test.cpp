#include "core/skeleton/checks.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = Finding::Kind;

/// A finding of `kind` at `node`, whatever else it says.
MATCHER_P2(IsAt, kind, node, "") {
  return arg.kind == kind && arg.node == node;
}

std::vector<Finding> ofKind(Kind kind, const Skeleton& skeleton, double spacing = 0,
                            const CheckOptions& options = {}) {
  std::vector<Finding> findings = check(skeleton, spacing, options);
  std::erase_if(findings, [&](const Finding& finding) { return finding.kind != kind; });
  return findings;
}

TEST(Check, FindsNothingInASoundPlant) {
  EXPECT_THAT(check(test::fork(3)), IsEmpty());
  EXPECT_THAT(check({}), IsEmpty());
  EXPECT_THAT(check(test::stick(1)), IsEmpty());
}

TEST(Check, FindsNothingInSimulatedPlants) {
  for (const test::SimulatedPlant* plant : {&test::simulatedTree(), &test::simulatedHerb()})
    EXPECT_THAT(check(plant->truth, pointSpacing(plant->cloud.positions())), IsEmpty());
}

TEST(Check, FindsASecondSuccessor) {
  Skeleton plant = test::fork(3);
  plant.setEdge(NodeId{4}, EdgeType::successor);
  const std::vector<Finding> found = check(plant);
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::twoSuccessors, test::forkTop)));
  EXPECT_THAT(found[0].others, ElementsAre(NodeId{2}, NodeId{4}));
  EXPECT_EQ(describe(found[0], plant), "node 1 has 2 successors: an axis continues once");
}

TEST(Check, FindsAnAxisThatBeginsAtAnOnlyChild) {
  Skeleton plant = test::stick(4);
  plant.setEdge(NodeId{2}, EdgeType::branching);
  const std::vector<Finding> found = check(plant);
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::loneBranch, NodeId{2})));
  EXPECT_EQ(describe(found[0], plant),
            "an axis begins at node 2, though nothing else goes on from node 1");
  plant.add({.position = {1, 0, 1}, .radius = 0.1, .parent = NodeId{1}});
  EXPECT_THAT(check(plant), IsEmpty()) << "it branches";
}

TEST(Check, FindsEdgesWithoutLength) {
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{2}, plant[NodeId{1}].position);
  EXPECT_THAT(check(plant), ElementsAre(IsAt(Kind::noLength, NodeId{2})));
}

TEST(Check, FindsWoodThickerThanWhatCarriesIt) {
  Skeleton plant = test::stick(3);
  plant.setRadius(NodeId{2}, 0.2);
  const std::vector<Finding> found = check(plant);
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::radiusAboveParent, NodeId{2})));
  const auto length = [](double value) { return std::to_string(std::lround(value * 10)) + " dm"; };
  const auto count = [](std::size_t number) { return std::to_string(number); };
  EXPECT_EQ(inEnglish(describe(found[0], plant, {length, count})),
            "node 2 is thicker than its parent: radius 2 dm on 1 dm");
}

TEST(Check, FindsPiecesBesideTheLargest) {
  Skeleton plant = test::stick(2);
  const NodeId root = plant.add({.position = {9, 0, 0}, .radius = 0.1});
  NodeId top = root;
  for (int i = 1; i < 5; ++i)
    top = plant.add({.position = {9, 0, 1.0 * i}, .radius = 0.1, .parent = top});
  const std::vector<Finding> found = check(plant);
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::separatePiece, NodeId{0})));
  EXPECT_EQ(describe(found[0], plant), "node 0 is the root of a separate piece of 2 nodes");
}

TEST(Check, FindsAllOfThousandsOfEdgesInOnePlace) {
  Skeleton plant;
  const NodeId foot = plant.add({.position = {0, 0, 0}});
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) // in bundles that lie apart
    plant.add({.position = {0.2 * (i % 4), 1e-6 * i, 1}, .parent = foot});
  const std::vector<Finding> found = ofKind(Kind::duplicatedEdge, plant);
  ASSERT_EQ(found.size(), count - 4U);
  for (const Finding& each : found)
    EXPECT_EQ(indexOf(each.others.front()), 1 + (indexOf(each.node) - 1) % 4);
}

TEST(Check, FindsTheSecondOfTwoEdgesInOnePlace) {
  Skeleton plant = test::fork(2);
  const Eigen::Vector3d beside(0.05, 0, 0); // of an edge of length 1.4
  plant.add({.position = plant[NodeId{2}].position + beside,
             .radius = 0.1,
             .parent = test::forkTop,
             .edge = EdgeType::branching});
  const std::vector<Finding> found = ofKind(Kind::duplicatedEdge, plant);
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::duplicatedEdge, NodeId{4})));
  EXPECT_THAT(found[0].others, ElementsAre(NodeId{2}));
  EXPECT_THAT(ofKind(Kind::duplicatedEdge, plant, 0, {.duplicateShare = 0.01}), IsEmpty());
  EXPECT_THAT(ofKind(Kind::duplicatedEdge, plant, 0, {.duplicateShare = 0}), IsEmpty());
}

// As no plant has, but a file may: it took minutes, and grew by the square of the branches.
TEST(Check, EndsSoonWhereAHundredThousandBranchesLeaveOneNode) {
  Skeleton plant;
  const NodeId root = plant.add({});
  constexpr int count = 100'000;
  for (int i = 0; i < count; ++i) { // all around, in a spiral
    const double height = 1 - (2 * i + 1.0) / count;
    const double width = std::sqrt(1 - height * height);
    const double angle = 2.399963 * i;
    plant.add({.position = {width * std::cos(angle), width * std::sin(angle), height},
               .parent = root,
               .edge = EdgeType::branching});
  }
  const std::vector<Finding> found = ofKind(Kind::duplicatedEdge, plant);
  EXPECT_GT(found.size(), 99'000U); // as near as they are, almost all lie on another
}

// From straight up it turns by the angle given.
Skeleton bent(double angle) {
  Skeleton plant = test::stick(3);
  plant.add(
      {.position = {std::sin(angle), 0, 2 + std::cos(angle)}, .radius = 0.1, .parent = NodeId{2}});
  return plant;
}

TEST(Check, FindsTurnsAboveTheAngle) {
  constexpr double degree = std::numbers::pi / 180;
  const std::vector<Finding> found = check(bent(120 * degree));
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::sharpTurn, NodeId{2})));
  EXPECT_NEAR(found[0].amount, 120 * degree, 1e-9);
  EXPECT_EQ(describe(found[0], bent(120 * degree)), "the axis turns by 120° at node 2");
  EXPECT_THAT(check(bent(80 * degree)), IsEmpty());
  EXPECT_THAT(check(bent(80 * degree), 0, {.sharpTurn = 70 * degree}),
              ElementsAre(IsAt(Kind::sharpTurn, NodeId{2})));
}

// The first edge of a branch begins amid its bearer: it may lead to the side, but not back.
TEST(Check, FindsBranchesThatTurnBackFromTheirBearer) {
  constexpr double degree = std::numbers::pi / 180;
  const auto branching = [](double angle) {
    Skeleton plant = bent(angle);
    plant.setEdge(NodeId{3}, EdgeType::branching);
    return plant;
  };
  EXPECT_THAT(ofKind(Kind::sharpTurn, branching(115 * degree)), IsEmpty());
  const std::vector<Finding> found = ofKind(Kind::sharpTurn, branching(140 * degree));
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::sharpTurn, NodeId{3})));
  EXPECT_THAT(found[0].others, ElementsAre(NodeId{2}));
  EXPECT_NEAR(found[0].amount, 140 * degree, 1e-9);
  EXPECT_EQ(describe(found[0], branching(140 * degree)),
            "the branch that begins at node 3 turns back by 140°");
  EXPECT_THAT(ofKind(Kind::sharpTurn, branching(115 * degree), 0, {.branchTurn = 110 * degree}),
              ElementsAre(IsAt(Kind::sharpTurn, NodeId{3})));
}

TEST(Check, FindsBranchesThatTurnBackFromTheirFirstEdge) {
  Skeleton plant = test::stick(3);
  const NodeId first = plant.add(
      {.position = {1, 0, 2}, .radius = 0.1, .parent = NodeId{1}, .edge = EdgeType::branching});
  const NodeId tip = plant.add({.position = {0.2, 0, 2.1}, .radius = 0.1, .parent = first});
  const std::vector<Finding> found = ofKind(Kind::sharpTurn, plant);
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::sharpTurn, first)));
  EXPECT_THAT(found[0].others, ElementsAre(tip));
}

// As regrown branches did: attached too high, it comes back by 150 degrees and goes on as it grew.
TEST(Check, FindsABranchThatFoldsBackWhateverItDoesLater) {
  Skeleton plant = test::stick(6);
  NodeId last = plant.add(
      {.position = {1, 0, 2.3}, .radius = 0.05, .parent = NodeId{4}, .edge = EdgeType::branching});
  const NodeId first = last;
  for (int i = 1; i <= 4; ++i)
    last = plant.add({.position = {1.0 + i, 0, 2.3 + i}, .radius = 0.05, .parent = last});
  const std::vector<Finding> found = ofKind(Kind::sharpTurn, plant);
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::sharpTurn, first)));
  EXPECT_NEAR(found[0].amount, std::numbers::pi - std::atan2(1, 1.7), 1e-9);
}

TEST(Check, TakesAsThickAsItsParentWhatIsSoToATenth) {
  Skeleton plant = test::stick(3);
  plant.setRadius(NodeId{2}, 0.109);
  EXPECT_THAT(check(plant), IsEmpty());
  plant.setRadius(NodeId{2}, 0.111);
  EXPECT_THAT(check(plant), ElementsAre(IsAt(Kind::radiusAboveParent, NodeId{2})));
}

/// A branch at the top of a trunk that comes down and ends `gap` from its axis.
Skeleton comingBack(double gap) {
  Skeleton plant = test::stick(9);
  NodeId last = plant.add(
      {.position = {3, 0, 8}, .radius = 0.1, .parent = NodeId{8}, .edge = EdgeType::branching});
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(3, 0, 4.5), Eigen::Vector3d(1.5, 0, 3.5), Eigen::Vector3d(gap, 0, 3.5)})
    last = plant.add({.position = place, .radius = 0.1, .parent = last});
  return plant;
}

TEST(Check, FindsABranchWhoseEndComesBackOntoWood) {
  const std::vector<Finding> found = ofKind(Kind::loop, comingBack(0.15)); // radii are 0.1
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::loop, NodeId{12})));
  EXPECT_THAT(found[0].others, ElementsAre(NodeId{4}));
  EXPECT_EQ(describe(found[0], comingBack(0.15)),
            "the axis that ends at node 12 comes back onto the wood at node 4");
  EXPECT_THAT(ofKind(Kind::loop, comingBack(0.25)), IsEmpty());
}

TEST(Check, FindsAnAxisThatComesBackToItself) {
  Skeleton plant = test::stick(1);
  NodeId last{0};
  constexpr int around = 16;
  for (int i = 1; i < 16; ++i) { // a ring, almost closed
    const double angle = 2 * std::numbers::pi * i / around;
    last = plant.add({.position = {std::cos(angle) - 1, 0, std::sin(angle)},
                      .radius = i == 15 ? 0.3 : 0.1,
                      .parent = last});
  }
  plant.setRadius(NodeId{1}, 0.3);
  EXPECT_THAT(ofKind(Kind::loop, plant, 0, {.detour = 4}), ElementsAre(IsAt(Kind::loop, last)));
}

TEST(AtSensitivity, LowersAllLimitsAlike) {
  const CheckOptions usual;
  const CheckOptions twice = atSensitivity({.sensitivity = 2});
  EXPECT_EQ(twice.clusterSize, usual.clusterSize / 2);
  EXPECT_EQ(twice.pointReach, usual.pointReach / 2);
  EXPECT_EQ(twice.fewestExpected, usual.fewestExpected / 2);
  EXPECT_NEAR(std::tan(twice.branchTurn / 2), std::tan(usual.branchTurn / 2) / 2, 1e-12);
  EXPECT_EQ(twice.ownReach, usual.ownReach) << "whose the points are stays";
  const CheckOptions back = atSensitivity([&] {
    CheckOptions options = twice;
    options.sensitivity = 0.5;
    return options;
  }());
  EXPECT_NEAR(back.sharpTurn, usual.sharpTurn, 1e-12);
  EXPECT_EQ(back.clusterSize, usual.clusterSize);
  EXPECT_GE(atSensitivity({.sensitivity = 64}).clusterSize, 1);
}

// It begins amid thick wood, a little below its bearer's node, and rises.
TEST(Check, TakesNoFirstEdgeForABranchThatTurnsBack) {
  Skeleton plant = test::stick(4);
  NodeId last = plant.add(
      {.position = {0.1, 0, 1.8}, .radius = 0.1, .parent = NodeId{2}, .edge = EdgeType::branching});
  for (int i = 1; i <= 3; ++i)
    last =
        plant.add({.position = {0.1 + 0.2 * i, 0, 1.8 + 0.2 * i}, .radius = 0.1, .parent = last});
  EXPECT_THAT(ofKind(Kind::sharpTurn, plant), IsEmpty());
}

// All edges meet at the node: that none of them touches another is found without looking at pairs.
TEST(Check, TakesANodeOfManyChildren) {
  Skeleton plant = test::stick(2);
  constexpr int many = 20'000;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < many; ++i) {
    const double z = 1 - (2 * i + 1.0) / many;
    const double across = std::sqrt(1 - z * z);
    plant.add({.position = Eigen::Vector3d(across * std::cos(golden * i),
                                           across * std::sin(golden * i), 1 + z),
               .radius = 1e-4,
               .parent = test::forkTop,
               .edge = i == 0 ? EdgeType::successor : EdgeType::branching});
  }
  EXPECT_THAT(ofKind(Kind::crossing, plant), IsEmpty());
}

/// A trunk 8 high, of radius 0.1, with two branches of radius 0.1, at 2 and 6; the upper one comes
/// down and passes the lower one, which is straight along x, at x = 3 at a distance of `gap`.
Skeleton passing(double gap) {
  Skeleton plant = test::stick(9);
  const NodeId lower = plant.add(
      {.position = {1, 0, 2}, .radius = 0.1, .parent = NodeId{2}, .edge = EdgeType::branching});
  plant.add({.position = {5, 0, 2}, .radius = 0.1, .parent = lower});
  const NodeId upper = plant.add(
      {.position = {3, gap, 6}, .radius = 0.1, .parent = NodeId{6}, .edge = EdgeType::branching});
  plant.add({.position = {3, gap, 0}, .radius = 0.1, .parent = upper, .edge = EdgeType::branching});
  plant.add({.position = {4, gap, 6}, .radius = 0.1, .parent = upper});
  return plant;
}

TEST(Check, FindsBranchesThatTouch) {
  const std::vector<Finding> found = check(passing(0.15)); // radii are 0.1
  ASSERT_THAT(found, ElementsAre(IsAt(Kind::crossing, NodeId{12})));
  EXPECT_THAT(found[0].others, ElementsAre(NodeId{10}));
  EXPECT_NEAR(found[0].amount, 0.15, 1e-12);
  EXPECT_THAT(check(passing(0.25)), IsEmpty());
}

TEST(Check, FindsBranchesNearerThanASpacingHoweverThin) {
  Skeleton plant = passing(0.25);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0);
  EXPECT_THAT(check(plant, 0.3), ElementsAre(IsAt(Kind::crossing, NodeId{12})));
  EXPECT_THAT(check(plant, 0.2), IsEmpty());
}

TEST(Check, ReportsTwoAxesThatTouchInManyPlacesOnce) {
  Skeleton plant = test::stick(9);
  NodeId last = plant.add(
      {.position = {3, 0, 0}, .radius = 0.1, .parent = NodeId{0}, .edge = EdgeType::branching});
  for (int i = 3; i < 9; ++i) // comes back to the trunk, and follows it
    last = plant.add({.position = {0.05, 0, i + 0.5}, .radius = 0.1, .parent = last});
  EXPECT_EQ(ofKind(Kind::crossing, plant).size(), 1);
}

TEST(Check, FindsTreesThatTouch) {
  Skeleton plant = test::stick(4);
  const NodeId root = plant.add({.position = {-1, 0, 1.5}, .radius = 0.05});
  plant.add({.position = {1, 0, 1.5}, .radius = 0.05, .parent = root});
  const std::vector<Finding> found = ofKind(Kind::crossing, plant);
  ASSERT_EQ(found.size(), 1);
  EXPECT_THAT(nodesOf(found[0]), testing::UnorderedElementsAre(NodeId{2}, NodeId{5}));
}

TEST(Check, FindsTheSameInAPlantThatIsMovedTurnedAndScaled) {
  const Skeleton plant = passing(0.15);
  Skeleton other = plant;
  const Eigen::AngleAxisd turn(1, Eigen::Vector3d(1, 2, 3).normalized());
  for (const NodeId id : plant.ids()) {
    other.setPosition(id, 1000 * (turn * plant[id].position) + Eigen::Vector3d(5e5, 0, 7));
    other.setRadius(id, 1000 * plant[id].radius);
  }
  EXPECT_THAT(check(other), ElementsAre(IsAt(Kind::crossing, NodeId{12})));
}

TEST(Finding, IsTheSameToAPersonAfterAnEdit) {
  const Finding turn{.kind = Kind::sharpTurn, .node = NodeId{3}, .amount = 2};
  Finding later = turn;
  later.amount = 2.5;
  EXPECT_TRUE(isSame(turn, later));
  later.node = NodeId{4};
  EXPECT_FALSE(isSame(turn, later));
  later = turn;
  later.kind = Kind::noLength;
  EXPECT_FALSE(isSame(turn, later));
  const Finding crossing{.kind = Kind::crossing, .node = NodeId{3}, .others = {NodeId{9}}};
  const Finding swapped{.kind = Kind::crossing, .node = NodeId{9}, .others = {NodeId{3}}};
  EXPECT_TRUE(isSame(crossing, swapped));
}

TEST(Finding, OfPointsIsTheSameWhileThePlacesOverlap) {
  Finding cluster{.kind = Kind::unexplainedPoints, .node = NodeId{3}, .place = {1, 0, 0}};
  cluster.reach = 0.5;
  Finding other = cluster;
  other.node = NodeId{7}; // another edge came nearer
  other.place = {1.3, 0, 0};
  EXPECT_TRUE(isSame(cluster, other));
  other.place = {2, 0, 0};
  EXPECT_FALSE(isSame(cluster, other));
}

TEST(Finding, HasANameForEachKind) {
  std::vector<std::string> names;
  for (int kind = 0; kind < findingKinds; ++kind)
    names.push_back(nameOf(static_cast<Kind>(kind)));
  EXPECT_THAT(names, ElementsAre("separate_piece", "two_successors", "lone_branch", "no_length",
                                 "duplicated_edge", "sharp_turn", "crossing", "loop",
                                 "radius_above_parent", "edges_without_points", "no_own_points",
                                 "beside_points", "short_foot", "unexplained_points"));
}

} // namespace
} // namespace espalier
