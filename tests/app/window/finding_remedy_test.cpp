#include "app/window/review/finding_remedy.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/edits.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

/// An upright axis of nodes at these heights.
Skeleton axisOf(const std::vector<double>& heights) {
  Skeleton plant;
  std::optional<NodeId> last;
  for (const double height : heights)
    last = plant.add({.position = {0, 0, height}, .radius = 0.01, .parent = last});
  return plant;
}

std::vector<Finding> turnsOf(const Skeleton& plant) {
  std::vector<Finding> found = check(plant, 0, {});
  std::erase_if(found, [](const Finding& one) { return one.kind != Finding::Kind::sharpTurn; });
  return found;
}

/// How many nodes its remedies remove until no turn is sharp; at most 10.
int removedUntilMended(Skeleton plant) {
  int removed = 0;
  for (; removed < 10 && !turnsOf(plant).empty(); ++removed) {
    const Remedy remedy = remedyOf(turnsOf(plant).front(), plant, 0);
    EXPECT_STREQ(remedy.action, "remove");
    SkeletonEditor editor(plant);
    removeNode(editor, remedy.nodes.front());
    static_cast<void>(editor.commit());
  }
  return removed;
}

TEST(FindingRemedy, RemovesTheNodeThatMendsASharpTurn) {
  EXPECT_EQ(removedUntilMended(axisOf({0, 1, 2, 1.5, 3, 4})), 1) << "one node lies back";
  // The root lies above the lower end of the stem: without node 1, the axis turns at node 2.
  EXPECT_EQ(removedUntilMended(axisOf({0.9, 0, 0.4, 0.8, 1.2, 1.6, 2})), 1);
  EXPECT_EQ(removedUntilMended(axisOf({0, 1, 2, 3, 4, 5, 4.1})), 1) << "the end lies back";
}

TEST(FindingRemedy, LeavesWhatBearsBranchesBesideATurn) {
  Skeleton plant = axisOf({0.9, 0, 0.4, 0.8, 1.2});
  plant.add(
      {.position = {1, 0, 0.9}, .radius = 0.01, .parent = NodeId{0}, .edge = EdgeType::branching});
  const std::vector<Finding> turns = turnsOf(plant);
  ASSERT_FALSE(turns.empty());
  EXPECT_NE(remedyOf(turns.front(), plant, 0).nodes.front(), NodeId{0});
}

TEST(FindingRemedy, RemovesWhatLeadsThroughAirToTheFootOfThePlant) {
  Skeleton plant = axisOf({-2, -1, 0, 1, 2});
  Finding air{.kind = Finding::Kind::edgesWithoutPoints, .node = NodeId{1}, .others = {NodeId{2}}};
  EXPECT_STREQ(remedyOf(air, plant, 0).action, "remove");
  EXPECT_EQ(remedyOf(air, plant, 0).nodes, (std::vector{NodeId{0}, NodeId{1}}));
  air.node = NodeId{3}; // amid the plant
  air.others.clear();
  EXPECT_STREQ(remedyOf(air, plant, 0).action, "tool_reparent");
  air = {.kind = Finding::Kind::edgesWithoutPoints, .node = NodeId{1}, .others = {}};
  plant.add(
      {.position = {1, 0, -2}, .radius = 0.01, .parent = NodeId{0}, .edge = EdgeType::branching});
  EXPECT_STREQ(remedyOf(air, plant, 0).action, "tool_reparent") << "the root bears another branch";
}

} // namespace
} // namespace espalier
