#include "core/skeleton/assemble_axes.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

TEST(AssembleAxes, LetsTheHeaviestChildContinue) {
  Skeleton plant = test::fork(3);
  plant.add({.position = {-1, 1, 3}, .parent = NodeId{3}});
  plant = withAssembledAxes(plant);
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::successor);
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::branching);
  EXPECT_EQ(plant[NodeId{4}].edge, EdgeType::branching);
}

TEST(AssembleAxes, CountsLengthNotNodes) {
  Skeleton plant = test::fork(2);
  plant.setPosition(NodeId{2}, {0, 0, 5}); // one long edge
  NodeId at{3};
  for (int i = 0; i < 5; ++i)
    at = plant.add({.position = {-1, 0, 2 + 0.1 * i}, .parent = at});
  EXPECT_EQ(withAssembledAxes(plant)[NodeId{2}].edge, EdgeType::successor);
}

TEST(AssembleAxes, EndsAnAxisAtATooSharpTurn) {
  Skeleton plant = test::stick(2);
  plant.add({.position = {5, 0, 1}, .parent = NodeId{1}});  // 90 degrees off
  plant.add({.position = {-1, 0, 1}, .parent = NodeId{1}}); // and so is what carries less
  EXPECT_EQ(withAssembledAxes(plant)[NodeId{2}].edge, EdgeType::branching);
  EXPECT_EQ(withAssembledAxes(plant, {.sharpestTurn = 1.6})[NodeId{2}].edge, EdgeType::successor);
}

TEST(AssembleAxes, GoesOnWhereNothingBranches) {
  Skeleton plant = test::stick(3, 1);
  plant.add({.position = {3, 0, 0}, .parent = NodeId{2}}); // 124 degrees off
  EXPECT_EQ(withAssembledAxes(plant)[NodeId{3}].edge, EdgeType::successor);
}

TEST(AssembleAxes, LooksPastAKinkOfOneEdge) {
  Skeleton plant = test::stick(6);
  NodeId at{5};
  at = plant.add({.position = {0.1, 0, 5}, .parent = at}); // a short step aside
  for (int i = 1; i < 6; ++i)
    at = plant.add({.position = {0.1, 0, 5.0 + i}, .parent = at});
  plant.add({.position = {-0.1, 0, 5.1}, .parent = NodeId{5}});
  EXPECT_EQ(withAssembledAxes(plant)[NodeId{6}].edge, EdgeType::successor);
  EXPECT_EQ(withAssembledAxes(plant, {.reach = 1})[NodeId{6}].edge, EdgeType::branching);
}

/// A stem along z to (0, 0, 2), and there two paths on: 0.9 long straight up, 1 long at 45 degrees.
struct TwoPathsOn {
  Skeleton plant = test::stick(3);
  NodeId straight = plant.add({.position = {0, 0, 2.9}, .parent = NodeId{2}});
  NodeId aside =
      plant.add({.position = {std::sqrt(0.5), 0, 2 + std::sqrt(0.5)}, .parent = NodeId{2}});

  /// Whether the straight path continues the axis, by weights and by how thick the paths are.
  bool goesStraight(const AxisOptions& options, double straightRadius = 0, double asideRadius = 0) {
    const Skeleton result =
        withAssembledAxes(plant, options, {0.1, 0.1, 0.1, straightRadius, asideRadius});
    EXPECT_NE(result[straight].edge, result[aside].edge) << "one of them";
    return result[straight].edge == EdgeType::successor;
  }
};

TEST(AssembleAxes, WeighsWhatAChildCarriesAgainstItsTurn) {
  TwoPathsOn paths;
  EXPECT_FALSE(paths.goesStraight({}));
  // The straight one carries 0.15 halvings less; the other turns by 0.75 times 60 degrees.
  EXPECT_FALSE(paths.goesStraight({.straightness = 0.19}));
  EXPECT_TRUE(paths.goesStraight({.straightness = 0.22}));
  EXPECT_FALSE(paths.goesStraight({.carried = 2, .straightness = 0.22}));
}

TEST(AssembleAxes, WeighsHowThickAChildIs) {
  TwoPathsOn paths;
  EXPECT_TRUE(paths.goesStraight({.thickness = 0.2}, 0.08, 0.04)) << "half as thick";
  EXPECT_FALSE(paths.goesStraight({.thickness = 0.1}, 0.08, 0.04));
  EXPECT_FALSE(paths.goesStraight({.thickness = 0.2}, 0.04, 0.08));
  EXPECT_FALSE(paths.goesStraight({.thickness = 9}, 0.08, 0)) << "not known: as thick";
}

TEST(AssembleAxes, PrefersAnythingToAChildThatCarriesNothing) {
  TwoPathsOn paths;
  paths.plant.setPosition(paths.straight, {0, 0, 2});
  EXPECT_FALSE(paths.goesStraight({.straightness = 6}));
}

TEST(AssembleAxes, GivesEachNodeAtMostOneSuccessor) {
  const Skeleton plant = withAssembledAxes(test::randomPlant(300, 1), {.sharpestTurn = 3.2});
  for (const NodeId id : plant.ids()) {
    int successors = 0;
    for (const NodeId child : plant.children(id))
      successors += plant[child].edge == EdgeType::successor ? 1 : 0;
    EXPECT_EQ(successors, plant.children(id).empty() ? 0 : 1);
  }
}

} // namespace
} // namespace espalier
