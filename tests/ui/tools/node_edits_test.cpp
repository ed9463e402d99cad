#include "core/base/error.h"
#include "tests/support/plants.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/structure_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkTop;
using testing::ElementsAre;

struct NodeEditsTest : testing::Test {
  PlantDocument document;

  void SetUp() override { document.openSkeleton(test::fork(3), "fork.mtg"); }

  void openScan() {
    RawPoints raw;
    for (int i = 0; i < 5; ++i)
      raw.positions.emplace_back(0.01 * (i - 2), 0, 1.2);
    document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  }
  void apply(const QString& id, const std::vector<NodeId>& nodes,
             std::optional<EdgePick> edge = std::nullopt) {
    const std::vector<NodeEdit> edits = nodeEdits();
    const auto found = std::ranges::find(edits, id, &NodeEdit::id);
    ASSERT_NE(found, edits.end()) << id.toStdString();
    found->apply(document, {.nodes = nodes, .edge = edge});
  }
};

TEST_F(NodeEditsTest, AreEachUndoneAsOneStepWithTheNameOfTheNode) {
  openScan();
  const QStringList others = {"make_branching", // it branches already
                              "center",         "extend_again",      "extend_foot",
                              "join",           "swap_continuation", "merge"}; // refused
  for (const NodeEdit& edit : nodeEdits()) {
    if (others.contains(edit.id) || edit.menu == pathMenu()) continue;
    edit.apply(document, {.nodes = {NodeId{3}}});
    const std::string name = edit.id.toStdString();
    ASSERT_EQ(document.undoStack().index(), 1) << name;
    EXPECT_TRUE(document.undoStack().undoText().contains("node 3")) << name;
    document.undoStack().undo();
    EXPECT_EQ(document.skeleton(), test::fork(3)) << name;
  }
}

// A stem of radius 0.1 from z = 0 on, whose points begin at z = -1.5.
TEST_F(NodeEditsTest, ExtendTheFootAsFarAsThePointsOfTheStemGo) {
  RawPoints raw;
  for (int i = 0; i <= 350; ++i)
    for (int k = 0; k < 12; ++k)
      raw.positions.emplace_back(0.1 * std::cos(k * M_PI / 6), 0.1 * std::sin(k * M_PI / 6),
                                 -1.5 + 0.01 * i);
  document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  apply("extend_foot", {test::forkRoot});
  const Eigen::Vector3d foot = document.skeleton()[test::forkRoot].position;
  EXPECT_NEAR(foot.z(), -1.5, 0.1);
  EXPECT_LT(foot.head<2>().norm(), 0.03);
  EXPECT_EQ(document.skeleton()[forkTop].position, Eigen::Vector3d(0, 0, 1));
  EXPECT_THROW(apply("extend_foot", {forkTop}), Error) << "no root";
  EXPECT_EQ(document.undoStack().index(), 1);
}

TEST_F(NodeEditsTest, AddAChildAndChooseIt) {
  apply("new_child", {NodeId{2}});
  EXPECT_EQ(document.skeleton()[NodeId{5}].parent, NodeId{2});
  EXPECT_TRUE(document.skeleton()[NodeId{5}].position.isApprox(Eigen::Vector3d(2, 0, 3)));
  EXPECT_THAT(document.selection().nodes(), ElementsAre(NodeId{5}));
}

// Node 2 of the fork stands at (1, 0, 2) and came from (0, 0, 1); the points lead up more steeply.
TEST_F(NodeEditsTest, LetANewChildTurnWithThePoints) {
  const Eigen::Vector3d foot(1, 0, 2);
  const Eigen::Vector3d along = Eigen::Vector3d(1, 0, 2).normalized();
  RawPoints raw;
  for (int i = 0; i < 400; ++i)
    raw.positions.emplace_back(foot + 0.01 * i * along +
                               Eigen::Vector3d(0.05 * std::cos(i), 0.05 * std::sin(i), 0));
  document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  apply("new_child", {NodeId{2}});
  const Eigen::Vector3d newEdge = document.skeleton()[NodeId{5}].position - foot;
  EXPECT_LT((newEdge - newEdge.dot(along) * along).norm(), 0.1)
      << "0.4 off if it had gone straight on";
  EXPECT_NEAR(newEdge.norm(), 1.31, 0.1) << "as far as edges are long in the mean";
}

// 4 of points above node 2: three edges.
TEST_F(NodeEditsTest, ExtendAgainAndAgainAsFarAsThePointsGo) {
  RawPoints raw;
  for (int i = 0; i < 400; ++i)
    raw.positions.emplace_back(Eigen::Vector3d(1, 0, 2) + 0.01 * i * Eigen::Vector3d(1, 0, 1) +
                               Eigen::Vector3d(0.05 * std::cos(i), 0.05 * std::sin(i), 0));
  document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  NodeId end{2};
  const auto extend = [&] {
    apply("extend_again", {end});
    end = document.selection().nodes().front();
  };
  int edges = 0;
  for (; edges < 20; ++edges)
    try {
      extend();
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()),
                "the points end here: New Child adds a node all the same");
      break;
    }
  EXPECT_GE(edges, 3);
  EXPECT_LE(edges, 6);
  const Eigen::Vector3d tip = document.skeleton()[end].position;
  EXPECT_LT((tip - Eigen::Vector3d(5, 0, 6)).norm(), 1);
  EXPECT_LT(tip.z(), 6.1) << "not beyond them";
  apply("new_child", {end});
  EXPECT_GT(document.skeleton()[document.selection().nodes().front()].position.z(), tip.z());
}

TEST_F(NodeEditsTest, MarkUnitStartsAndTakeTheMarksOffAgain) {
  apply("mark_unit_start", {NodeId{2}, NodeId{3}});
  EXPECT_TRUE(document.skeleton()[NodeId{2}].isMarked && document.skeleton()[NodeId{3}].isMarked);
  apply("mark_unit_start", {NodeId{2}});
  EXPECT_FALSE(document.skeleton()[NodeId{2}].isMarked);
  EXPECT_EQ(document.undoStack().undoText(), "Take the mark off node 2");
  document.undoStack().undo();
  EXPECT_TRUE(document.skeleton()[NodeId{2}].isMarked);
}

TEST_F(NodeEditsTest, SplitTheEdgeInTheMiddleOrWhereThePointerIs) {
  apply("split_edge", {NodeId{2}});
  EXPECT_TRUE(document.skeleton()[NodeId{5}].position.isApprox(Eigen::Vector3d(0.5, 0, 1.5)));
  apply("split_edge", {NodeId{2}}, EdgePick{forkTop, 0.25, {0, 0, 0.25}});
  EXPECT_TRUE(document.skeleton()[NodeId{6}].position.isApprox(Eigen::Vector3d(0, 0, 0.25)));
}

TEST_F(NodeEditsTest, RemoveNodesTogetherWithThoseTheyCarry) {
  apply("remove_subtree", {forkTop, NodeId{3}}); // the second goes with the first
  EXPECT_EQ(document.skeleton().size(), 1U);
}

TEST_F(NodeEditsTest, ChangeTheTypeOfAnEdge) {
  apply("make_axial", {NodeId{4}});
  EXPECT_EQ(document.skeleton()[NodeId{4}].edge, EdgeType::successor);
  EXPECT_EQ(document.skeleton()[NodeId{2}].edge, EdgeType::branching);
  apply("make_branching", {NodeId{4}});
  EXPECT_EQ(document.skeleton()[NodeId{4}].edge, EdgeType::branching);
}

TEST_F(NodeEditsTest, ScaleTheRadiusByFivePercent) {
  apply("radius_up", {NodeId{2}});
  EXPECT_DOUBLE_EQ(document.skeleton()[NodeId{2}].radius, 0.105);
  apply("radius_down", {NodeId{3}});
  EXPECT_DOUBLE_EQ(document.skeleton()[NodeId{3}].radius, 0.095);
}

TEST_F(NodeEditsTest, RefuseToScaleARadiusThatIsNotKnown) {
  setRadius(document, {NodeId{2}}, 0);
  EXPECT_THROW(apply("radius_up", {NodeId{2}}), Error);
}

TEST_F(NodeEditsTest, StickANodeToThePoints) {
  openScan();
  apply("stick", {forkTop});
  EXPECT_TRUE(document.skeleton()[forkTop].position.isApprox(Eigen::Vector3d(0, 0, 1.2), 1e-6));
}

TEST_F(NodeEditsTest, StickAllThatANodeCarries) {
  openScan();
  apply("stick_subtree", {forkTop});
  EXPECT_TRUE(document.skeleton()[NodeId{4}].position.isApprox(Eigen::Vector3d(0, 0, 1.2), 1e-6));
  EXPECT_EQ(document.skeleton()[test::forkRoot].position, Eigen::Vector3d::Zero());
}

TEST_F(NodeEditsTest, SayThatThereIsNoScanToStickTo) {
  EXPECT_THAT([&] { apply("stick", {forkTop}); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("open the scan first")));
}

TEST_F(NodeEditsTest, RefuseTheEdgeOfARoot) {
  for (const char* id : {"split_edge", "make_axial", "make_branching"})
    EXPECT_THROW(apply(id, {test::forkRoot}), Error) << id;
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(NodeEditsTest, MeanTheChosenNodesUnlessThePointerIsOnAnother) {
  document.selection().set({NodeId{2}, NodeId{3}});
  const auto meant = [&](const Pick& under) {
    return targetOf(document, under, Eigen::Vector3d::UnitY()).nodes;
  };
  EXPECT_THAT(meant({}), ElementsAre(NodeId{2}, NodeId{3}));
  EXPECT_THAT(meant({.node = NodeId{3}}), ElementsAre(NodeId{2}, NodeId{3}));
  EXPECT_THAT(meant({.node = NodeId{4}}), ElementsAre(NodeId{4}));
  EXPECT_THAT(meant({.node = NodeId{99}}), ElementsAre(NodeId{2}, NodeId{3})) << "it is gone";
}

} // namespace
} // namespace espalier
