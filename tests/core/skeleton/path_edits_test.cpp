#include "core/base/random.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "tests/core/skeleton/edited.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <functional>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using Eigen::Vector3d;
using test::edited;
using test::expectRefused;
using testing::ElementsAre;

/// Nodes at the given heights, each on the one before.
Skeleton stickThrough(const std::vector<Vector3d>& places) {
  Skeleton plant;
  std::optional<NodeId> parent;
  for (const Vector3d& place : places)
    parent = plant.add({.position = place, .radius = 0.1, .parent = parent});
  return plant;
}

std::vector<NodeId> pathUp(const Skeleton& plant) {
  return pathBetween(plant, NodeId{0}, NodeId{static_cast<std::uint32_t>(plant.idEnd() - 1)});
}

TEST(MeanEdgeLength, IsThatOfAllEdges) {
  EXPECT_DOUBLE_EQ(meanEdgeLength(stickThrough({{0, 0, 0}, {0, 0, 1}, {0, 0, 4}})), 2);
  EXPECT_EQ(meanEdgeLength(Skeleton()), 0);
  EXPECT_EQ(meanEdgeLength(test::stick(1)), 0);
}

TEST(Straighten, KeepsTheSharesOfTheLength) {
  // Two steps of 5 and one of 10: at a quarter and at a half of the length.
  Skeleton plant = stickThrough({{0, 0, 0}, {3, 0, 4}, {0, 0, 8}, {0, 0, 18}});
  plant = edited(plant, [&](SkeletonEditor& editor) { straighten(editor, pathUp(plant)); });
  EXPECT_TRUE(plant[NodeId{1}].position.isApprox(Vector3d(0, 0, 4.5)));
  EXPECT_TRUE(plant[NodeId{2}].position.isApprox(Vector3d(0, 0, 9)));
  EXPECT_EQ(plant[NodeId{3}].position, Vector3d(0, 0, 18));
}

TEST(Straighten, GoesOverABranching) {
  Skeleton plant = test::fork(2); // from one shoot over the top to the other
  plant = edited(plant, [&](SkeletonEditor& editor) {
    straighten(editor, pathBetween(plant, NodeId{2}, NodeId{3}));
  });
  EXPECT_TRUE(plant[test::forkTop].position.isApprox(Vector3d(0, 0, 2)));
}

TEST(Straighten, RefusesAnEdge) {
  expectRefused(test::stick(3), "no node between", [](SkeletonEditor& editor) {
    straighten(editor, {NodeId{0}, NodeId{1}});
  });
}

TEST(InterpolateRadii, GoesByTheLengthAlongThePath) {
  Skeleton plant = stickThrough({{0, 0, 0}, {0, 0, 1}, {0, 0, 4}});
  plant.setRadius(NodeId{0}, 0.5);
  plant.setRadius(NodeId{1}, 9);
  plant = edited(plant, [&](SkeletonEditor& editor) { interpolateRadii(editor, pathUp(plant)); });
  EXPECT_DOUBLE_EQ(plant[NodeId{1}].radius, 0.4); // a quarter of the difference from 0.5 to 0.1
  EXPECT_DOUBLE_EQ(plant[NodeId{0}].radius, 0.5);
}

TEST(InterpolateRadii, RefusesAnEndWithoutRadius) {
  Skeleton plant = test::stick(3);
  plant.setRadius(NodeId{2}, 0);
  expectRefused(plant, "node 2 has no radius",
                [&](SkeletonEditor& editor) { interpolateRadii(editor, pathUp(plant)); });
}

TEST(ThinOut, LeavesTheEndsAndWhatBranches) {
  Skeleton plant = test::stick(6);
  plant.add({.position = {1, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  plant.setMarked(NodeId{4}, true);
  plant = edited(plant, [&](SkeletonEditor& editor) {
    thinOut(editor, pathBetween(plant, NodeId{0}, NodeId{5}));
  });
  EXPECT_THAT(plant.ids(),
              testing::UnorderedElementsAre(NodeId{0}, NodeId{2}, NodeId{4}, NodeId{5}, NodeId{6}));
  EXPECT_EQ(plant[NodeId{5}].edge, EdgeType::successor);
}

TEST(ThinOut, LeavesTheStartsOfUnits) {
  Skeleton plant = test::stick(4);
  plant.setEntities(NodeId{2}, {{.scale = 2, .symbol = "A"}, {.scale = 3, .symbol = "E"}});
  plant = edited(plant, [&](SkeletonEditor& editor) { thinOut(editor, pathUp(plant)); });
  EXPECT_THAT(plant.ids(), ElementsAre(NodeId{0}, NodeId{2}, NodeId{3}));
}

TEST(ThinOut, RefusesWhereNothingCanGo) {
  Skeleton plant = test::stick(3);
  plant.setMarked(NodeId{1}, true);
  expectRefused(plant, "nothing can go",
                [&](SkeletonEditor& editor) { thinOut(editor, pathUp(plant)); });
}

TEST(Smooth, LeavesAnEvenStraightAxis) {
  const Skeleton plant = test::stick(9);
  const Skeleton result =
      edited(plant, [&](SkeletonEditor& editor) { smooth(editor, plant.ids(), 1.5); });
  for (const NodeId id : plant.ids())
    EXPECT_TRUE(result[id].position.isApprox(plant[id].position)) << indexOf(id);
}

TEST(Smooth, WeighsNeighborsByAGaussianOfTheirDistance) {
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{0}, {-3, 0, 0});
  plant.setPosition(NodeId{1}, {0, 4, 0});
  plant.setPosition(NodeId{2}, {3, 0, 0}); // both edges 5 long
  plant = edited(plant, [](SkeletonEditor& editor) { smooth(editor, {NodeId{1}}, 5); });
  EXPECT_NEAR(plant[NodeId{1}].position.y(), 4 / (1 + 2 * std::exp(-0.5)), 1e-12);
}

TEST(Smooth, TakesNoiseOffAnAxisButKeepsItsEnds) {
  Random random(3);
  Skeleton plant = test::stick(60);
  for (const NodeId id : plant.ids())
    plant.setPosition(id, plant[id].position + 0.2 * Vector3d(random.normal(), 0, 0));
  const Skeleton result =
      edited(plant, [&](SkeletonEditor& editor) { smooth(editor, plant.ids(), 2); });
  double before = 0;
  double after = 0;
  for (const NodeId id : plant.ids()) {
    before += std::abs(plant[id].position.x());
    after += std::abs(result[id].position.x());
  }
  EXPECT_LT(after, 0.7 * before);
  for (const NodeId end : {NodeId{0}, NodeId{59}})
    EXPECT_EQ(result[end].position, plant[end].position);
}

TEST(Smooth, TurnsWithThePlantAndMovesTheChosenNodesOnly) {
  const Skeleton plant = stickThrough({{0, 0, 0}, {1, 0, 1}, {0, 0, 2}, {1, 0, 3}, {0, 0, 4}});
  const auto smoothed = [](const Skeleton& each) {
    return edited(each, [](SkeletonEditor& editor) { smooth(editor, {NodeId{1}, NodeId{3}}, 1); });
  };
  const Skeleton straight = smoothed(plant);
  EXPECT_EQ(straight[NodeId{2}].position, plant[NodeId{2}].position);
  Skeleton turned = plant;
  const auto turn = [](const Vector3d& place) { return Vector3d(place.z(), place.x(), place.y()); };
  for (const NodeId id : plant.ids())
    turned.setPosition(id, turn(plant[id].position));
  EXPECT_TRUE(smoothed(turned)[NodeId{1}].position.isApprox(turn(straight[NodeId{1}].position)));
}

TEST(Resample, SpacesAStickEvenly) {
  Skeleton plant = stickThrough({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 9}});
  plant.setRadius(NodeId{0}, 1);
  plant.setRadius(NodeId{1}, 0.9);
  plant.setRadius(NodeId{2}, 0.8);
  plant = edited(plant, [&](SkeletonEditor& editor) { resample(editor, plant.ids(), 3); });
  ASSERT_THAT(plant.ids(), ElementsAre(NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3}));
  EXPECT_TRUE(plant[NodeId{1}].position.isApprox(Vector3d(0, 0, 3)));
  EXPECT_TRUE(plant[NodeId{2}].position.isApprox(Vector3d(0, 0, 6)));
  EXPECT_NEAR(plant[NodeId{1}].radius, 0.8 - 0.7 / 7, 1e-12);
}

TEST(Resample, AddsAndRemovesNodes) {
  const Skeleton plant = test::stick(9);
  const Skeleton fine =
      edited(plant, [&](SkeletonEditor& editor) { resample(editor, plant.ids(), 0.25); });
  EXPECT_EQ(fine.size(), 33U);
  const Skeleton coarse =
      edited(plant, [&](SkeletonEditor& editor) { resample(editor, plant.ids(), 4); });
  EXPECT_EQ(coarse.size(), 3U);
  for (const Skeleton* result : {&fine, &coarse})
    for (const NodeId id : result->ids()) {
      if (!(*result)[id].parent) continue;
      const double edge =
          ((*result)[id].position - (*result)[*(*result)[id].parent].position).norm();
      EXPECT_NEAR(edge, result == &fine ? 0.25 : 4, 1e-9);
      EXPECT_EQ((*result)[id].edge, EdgeType::successor);
    }
}

TEST(Resample, KeepsBranchingsAndTips) {
  const Skeleton plant = test::fork(3);
  const Skeleton result =
      edited(plant, [&](SkeletonEditor& editor) { resample(editor, plant.ids(), 100); });
  EXPECT_EQ(result, plant);
  const Skeleton fine =
      edited(plant, [&](SkeletonEditor& editor) { resample(editor, plant.ids(), 0.5); });
  for (const NodeId id : plant.ids()) {
    ASSERT_TRUE(fine.contains(id));
    EXPECT_EQ(fine[id].position, plant[id].position);
  }
  EXPECT_EQ(fine.children(test::forkTop).size(), 3U);
  EXPECT_EQ(fine.size(), 5U + 1U + 3U * 2U); // sqrt 2 / 0.5 is nearest to 3 edges
}

TEST(Resample, ChangesOnlyWhatLiesBetweenTheChosenNodes) {
  const Skeleton plant = test::stick(9);
  const Skeleton result = edited(plant, [&](SkeletonEditor& editor) {
    resample(editor, pathBetween(plant, NodeId{2}, NodeId{6}), 4);
  });
  EXPECT_THAT(result.ids(),
              ElementsAre(NodeId{0}, NodeId{1}, NodeId{2}, NodeId{6}, NodeId{7}, NodeId{8}));
}

TEST(Resample, RefusesEdgesTooShort) {
  const Skeleton plant = test::stick(3);
  expectRefused(plant, "over a million nodes",
                [&](SkeletonEditor& editor) { resample(editor, plant.ids(), 1e-7); });
}

} // namespace
} // namespace espalier
