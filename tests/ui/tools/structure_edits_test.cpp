#include "core/base/error.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "ui/tools/structure_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct StructureEditsTest : testing::Test {
  PlantDocument document;

  void open(const Skeleton& skeleton) { document.openSkeleton(skeleton, "plant.mtg"); }
  void apply(const QString& id, const std::vector<NodeId>& nodes,
             std::optional<EdgePick> edge = std::nullopt) {
    const std::vector<NodeEdit> edits = nodeEdits();
    const auto found = std::ranges::find(edits, id, &NodeEdit::id);
    ASSERT_NE(found, edits.end()) << id.toStdString();
    found->apply(document, {.nodes = nodes, .edge = edge});
  }
  const Node& node(std::uint32_t id) { return document.skeleton()[NodeId{id}]; }
  [[nodiscard]] QString undoText() { return document.undoStack().undoText(); }
};

/// Two sticks of three nodes beside each other, 0 to 2 and 3 to 5.
Skeleton twoSticks() {
  Skeleton plant = test::stick(3);
  std::optional<NodeId> parent;
  for (int i = 0; i < 3; ++i)
    parent = plant.add({.position = {0.5, 0, 1.0 * i}, .radius = 0.1, .parent = parent});
  return plant;
}

TEST_F(StructureEditsTest, CutEachOfTheChosenNodesAsOneStep) {
  open(test::fork(3));
  apply("cut_off", {NodeId{2}, NodeId{4}});
  EXPECT_THAT(document.skeleton().roots(), ElementsAre(forkRoot, NodeId{2}, NodeId{4}));
  EXPECT_EQ(undoText(), "Cut off 2 nodes");
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(StructureEditsTest, CutTheEdgeUnderThePointer) {
  open(test::fork(3));
  apply("cut_off", {}, EdgePick{NodeId{3}, 0.5, {0, 0, 1.5}});
  EXPECT_THAT(document.skeleton().roots(), ElementsAre(forkRoot, NodeId{3}));
}

TEST_F(StructureEditsTest, JoinOneNodeToTheNearestTree) {
  open(twoSticks());
  apply("join", {NodeId{3}});
  EXPECT_EQ(node(3).parent, NodeId{0});
  EXPECT_EQ(undoText(), "Join node 3 to node 0");
}

TEST_F(StructureEditsTest, JoinSeveralToTheLastOneChosen) {
  Skeleton plant = twoSticks();
  plant.add({.position = {5, 0, 0}});
  open(plant);
  apply("join", {NodeId{3}, NodeId{6}, NodeId{4}, NodeId{2}}); // 4 comes with 3
  EXPECT_THAT(document.skeleton().roots(), ElementsAre(NodeId{0}));
  EXPECT_EQ(node(3).parent, NodeId{2});
  EXPECT_EQ(node(6).parent, NodeId{2});
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(StructureEditsTest, SayWhyNothingCanBeJoined) {
  open(test::fork(3));
  EXPECT_THAT([&] { apply("join", {NodeId{3}}); }, ThrowsMessage<Error>(HasSubstr("one tree")));
  EXPECT_THAT(
      [&] {
        apply("join", {NodeId{3}, NodeId{2}});
      },
      ThrowsMessage<Error>(HasSubstr("belong to one tree")));
  EXPECT_THAT([&] { apply("make_root", {forkRoot}); },
              ThrowsMessage<Error>(HasSubstr("the root already")));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(StructureEditsTest, SwapTheContinuationAndMakeARoot) {
  open(test::fork(2));
  apply("swap_continuation", {forkTop});
  EXPECT_EQ(node(3).edge, EdgeType::successor);
  apply("make_root", {NodeId{3}});
  EXPECT_THAT(document.skeleton().roots(), ElementsAre(NodeId{3}));
}

TEST_F(StructureEditsTest, MergeTheChosenNodesAndSelectTheOneThatStays) {
  open(test::stick(4));
  apply("merge", {NodeId{2}, NodeId{1}});
  EXPECT_EQ(node(1).position.z(), 1.5);
  EXPECT_THAT(document.selection().nodes(), ElementsAre(NodeId{1}));
}

TEST_F(StructureEditsTest, TurnAPathAroundFromEitherEnd) {
  for (const auto& ends : {std::vector{NodeId{1}, NodeId{3}}, {NodeId{3}, NodeId{1}}}) {
    open(test::stick(4));
    apply("turn_around", ends);
    EXPECT_EQ(node(3).parent, NodeId{0});
    EXPECT_EQ(node(1).parent, NodeId{2});
  }
}

TEST_F(StructureEditsTest, MeanTheAxisOfASingleNode) {
  Skeleton plant = test::stick(4);
  plant.setPosition(NodeId{1}, {1, 0, 1});
  open(plant);
  apply("straighten", {NodeId{2}});
  EXPECT_NEAR(node(1).position.x(), 0, 1e-12);
  EXPECT_EQ(undoText(), "Straighten the path of node 2");
}

TEST_F(StructureEditsTest, SmoothTheChosenNodesOnly) {
  Skeleton plant = test::stick(5);
  plant.setPosition(NodeId{1}, {1, 0, 1});
  plant.setPosition(NodeId{3}, {1, 0, 3});
  open(plant);
  apply("smooth", {NodeId{3}});
  EXPECT_LT(node(3).position.x(), 0.8);
  EXPECT_EQ(node(1).position.x(), 1);
}

TEST_F(StructureEditsTest, SmoothThePathBetweenTwoNodes) {
  Skeleton plant = test::stick(6);
  for (const NodeId id : {NodeId{1}, NodeId{3}, NodeId{4}})
    plant.setPosition(id, plant[id].position + Eigen::Vector3d(1, 0, 0));
  open(plant);
  apply("smooth", {NodeId{4}, NodeId{1}});
  EXPECT_EQ(node(1).position, plant[NodeId{1}].position) << "the ends stay";
  EXPECT_EQ(node(4).position, plant[NodeId{4}].position);
  EXPECT_GT(node(2).position.x(), 0.1);
  EXPECT_LT(node(3).position.x(), 0.9);
}

TEST_F(StructureEditsTest, InterpolateRadiiAndThinOutAPath) {
  Skeleton plant = test::stick(5);
  plant.setRadius(NodeId{4}, 0.5);
  open(plant);
  apply("interpolate_radii", {NodeId{0}, NodeId{4}});
  EXPECT_DOUBLE_EQ(node(2).radius, 0.3);
  apply("thin_out", {NodeId{0}, NodeId{4}});
  EXPECT_EQ(document.skeleton().size(), 2U);
}

TEST_F(StructureEditsTest, GiveAPathMoreOrFewerNodes) {
  open(test::stick(9));
  apply("more_nodes", {NodeId{0}, NodeId{8}});
  EXPECT_EQ(document.skeleton().size(), 17U);
  document.undoStack().undo();
  apply("fewer_nodes", {NodeId{0}, NodeId{8}});
  EXPECT_EQ(document.skeleton().size(), 5U);
  document.undoStack().undo();
  apply("fewer_nodes", {NodeId{4}, NodeId{5}, NodeId{6}, NodeId{7}, NodeId{8}});
  EXPECT_EQ(document.skeleton().size(), 7U) << "the four edges above node 4 became two";
}

TEST_F(StructureEditsTest, SpaceTheNodesOfAPathEvenly) {
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{1}, {0, 0, 0.25});
  open(plant);
  apply("space_evenly", {NodeId{0}});
  EXPECT_NEAR(node(1).position.z(), 1, 1e-12);
}

TEST_F(StructureEditsTest, RefuseAPathThatIsNone) {
  open(twoSticks());
  for (const char* id : {"straighten", "interpolate_radii", "thin_out", "more_nodes"})
    EXPECT_THROW(apply(id, {NodeId{0}, NodeId{5}}), Error) << id;
  open(test::stick(1));
  for (const char* id : {"turn_around", "smooth", "space_evenly"})
    EXPECT_THROW(apply(id, {NodeId{0}}), Error) << id;
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(StructureEditsTest, CenterANodeInTheRingOfPointsAroundIt) {
  RawPoints raw;
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, -0.1}, {0, 0, 2.1}, 0.05, 0.01);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>());
  document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{1}, {0.02, 0.01, 1});
  open(plant);
  apply("center", {NodeId{1}});
  EXPECT_LT(node(1).position.head<2>().norm(), 0.004);
  plant.setPosition(NodeId{1}, {1, 0, 1});
  open(plant);
  EXPECT_THAT([&] { apply("center", {NodeId{1}}); },
              ThrowsMessage<Error>(HasSubstr("show no middle")));
  document.setScan(nullptr, {});
  EXPECT_THAT([&] { apply("center", {NodeId{1}}); },
              ThrowsMessage<Error>(HasSubstr("open the scan first")));
}

TEST_F(StructureEditsTest, CenterANodeInABladeThatShowsNoCircle) {
  RawPoints raw;
  for (double z = -0.1; z <= 2.1; z += 0.01)
    for (double x = -0.08; x <= 0.08; x += 0.01)
      raw.positions.emplace_back(x, 0, z);
  document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  Skeleton plant = test::stick(5, 0.5);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0.03);
  plant.setPosition(NodeId{2}, {0.06, 0.02, 1});
  open(plant);
  apply("center", {NodeId{2}});
  EXPECT_LT(std::abs(node(2).position.x()), 0.02);
  EXPECT_LE(std::abs(node(2).position.y()), 0.03);
  EXPECT_NEAR(node(2).position.z(), 1, 0.02);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), plant);
}

} // namespace
} // namespace espalier
