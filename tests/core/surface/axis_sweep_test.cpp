#include "core/surface/axis_sweep.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <numbers>

namespace espalier {
namespace {

constexpr double turn = 0.26;

std::vector<double> radiiOf(const Skeleton& skeleton) {
  std::vector<double> radii(skeleton.idEnd(), 0.0);
  for (const NodeId id : skeleton.ids())
    radii[indexOf(id)] = skeleton[id].radius;
  return radii;
}

std::vector<Section> sectionsOfAxis(const Skeleton& skeleton, std::size_t place) {
  return sectionsOf(skeleton, axes(skeleton)[place], radiiOf(skeleton), turn);
}

/// A quarter of a circle of radius 1 about the origin, in nodes 15 degrees apart.
Skeleton arc() {
  Skeleton plant;
  std::optional<NodeId> parent;
  for (int i = 0; i <= 6; ++i) {
    const double angle = i * std::numbers::pi / 12;
    parent = plant.add(
        {.position = {std::cos(angle), std::sin(angle), 0}, .radius = 0.1, .parent = parent});
  }
  return plant;
}

TEST(AxisSweep, AStraightAxisHasASectionAtEachNodeAcrossIt) {
  const std::vector<Section> sections = sectionsOfAxis(test::stick(4), 0);
  ASSERT_EQ(sections.size(), 4U);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    EXPECT_EQ(sections[i].center, Eigen::Vector3d(0, 0, double(i)));
    EXPECT_TRUE(sections[i].normal.isApprox(Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE(sections[i].forward.isApprox(sections[0].forward)) << "it twists";
  }
}

TEST(AxisSweep, ASmoothCurveFollowsTheArcItsNodesLieOn) {
  const std::vector<Section> sections = sectionsOfAxis(arc(), 0);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const bool isEnd = i == 0 || i + 1 == sections.size();
    const Eigen::Vector3d outward = sections[i].center.normalized();
    EXPECT_NEAR(sections[i].center.norm(), 1, 0.001);
    // Straight edges would be off by half of the 15 degrees between nodes, 0.13.
    EXPECT_NEAR(outward.dot(sections[i].normal), 0, isEnd ? 0.07 : 0.01);
  }
}

TEST(AxisSweep, NeighboringSectionsTurnLittle) {
  Skeleton corner;
  const NodeId foot = corner.add({.position = {0, 0, 0}, .radius = 0.1});
  const NodeId knee = corner.add({.position = {0, 0, 1}, .radius = 0.1, .parent = foot});
  corner.add({.position = {1, 0, 1}, .radius = 0.1, .parent = knee});
  const std::vector<Section> sections = sectionsOfAxis(corner, 0);
  for (std::size_t i = 1; i < sections.size(); ++i)
    EXPECT_GT(sections[i - 1].normal.dot(sections[i].normal), std::cos(1.001 * turn));
}

TEST(AxisSweep, FramesDoNotTwistInAPlane) {
  // In a plane, a frame without twist keeps its angle to the plane.
  const std::vector<Section> sections = sectionsOfAxis(arc(), 0);
  const double first = sections.front().forward.z();
  for (const Section& section : sections) {
    EXPECT_NEAR(section.forward.z(), first, 1e-9);
    EXPECT_NEAR(section.forward.dot(section.normal), 0, 1e-9);
    EXPECT_NEAR(section.forward.norm(), 1, 1e-9);
  }
}

TEST(AxisSweep, ABranchBeginsAtItsBearerAndLeavesInItsDirection) {
  const Skeleton plant = test::fork(2); // on forkTop, one up and one to the side, at 45 degrees
  const std::vector<Section> branch = sectionsOfAxis(plant, 1);
  EXPECT_EQ(branch.front().center, plant[test::forkTop].position);
  const Eigen::Vector3d side = (branch.back().center - branch.front().center).normalized();
  EXPECT_GT(branch.front().normal.z(), side.z()) << "it leaves at its own angle";
  EXPECT_LT(branch.front().normal.dot(branch.back().normal), 0.999);
}

TEST(AxisSweep, ABranchIsNoThickerThanItsBearerWhereItBegins) {
  Skeleton plant = test::fork(2);
  const Axis branch = axes(plant)[1];
  plant.setRadius(test::forkTop, 0.02);
  plant.setRadius(branch.front(), 0.5);
  EXPECT_DOUBLE_EQ(sectionsOf(plant, branch, radiiOf(plant), turn).front().radius, 0.02);
}

TEST(AxisSweep, NodesInOnePlaceAreOne) {
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{1}, plant[NodeId{0}].position);
  EXPECT_EQ(sectionsOfAxis(plant, 0).size(), 2U);
}

TEST(AxisSweep, AnAxisWithoutLengthHasNoSections) {
  EXPECT_TRUE(sectionsOfAxis(test::stick(1), 0).empty());
  Skeleton plant = test::stick(2);
  plant.setPosition(NodeId{1}, plant[NodeId{0}].position);
  EXPECT_TRUE(sectionsOfAxis(plant, 0).empty());
}

TEST(AxisSweep, AnAxisThatTurnsRightBackStaysFinite) {
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{2}, plant[NodeId{0}].position);
  for (const Section& section : sectionsOfAxis(plant, 0)) {
    EXPECT_TRUE(section.center.allFinite());
    EXPECT_NEAR(section.normal.norm(), 1, 1e-9);
    EXPECT_NEAR(section.forward.norm(), 1, 1e-9);
  }
}

} // namespace
} // namespace espalier
