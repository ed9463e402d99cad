#include "core/skeleton/best_successor.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <vector>

namespace espalier {
namespace {

/// A stem along z to (0, 0, 2), of radius 0.1.
Skeleton stem() {
  Skeleton plant = test::stick(3);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0.1);
  return plant;
}

/// Nodes from the tip of the stem on, in steps of one length.
NodeId growFromTip(Skeleton& plant, const Eigen::Vector3d& step, double radius, int nodes) {
  NodeId last{2};
  std::vector<NodeId> added;
  for (int i = 0; i < nodes; ++i) {
    last = plant.add({.position = plant[last].position + step, .radius = radius, .parent = last});
    added.push_back(last);
  }
  return added.front();
}

TEST(BestSuccessor, GoesOnStraightWhateverIsFirstOrCarriesMore) {
  Skeleton plant = stem();
  const NodeId aside = growFromTip(plant, {0.7, 0, 0.7}, 0.1, 9);
  const NodeId straight = growFromTip(plant, {0.1, 0, 1}, 0.1, 2);
  EXPECT_EQ(bestSuccessor(plant, {aside, straight}), straight);
  EXPECT_EQ(bestSuccessor(plant, {straight, aside}), straight);
}

TEST(BestSuccessor, IsTheThickestOfThoseThatTurnAsMuch) {
  Skeleton plant = stem();
  const NodeId thin = growFromTip(plant, {0.5, 0, 1}, 0.02, 3);
  const NodeId thick = growFromTip(plant, {-0.5, 0, 1}, 0.09, 3);
  EXPECT_EQ(bestSuccessor(plant, {thin, thick}), thick);
}

TEST(BestSuccessor, IsOneOfThemHoweverSharplyAllTurn) {
  Skeleton plant = stem();
  const NodeId back = growFromTip(plant, {0.5, 0, -1}, 0.1, 3);
  const NodeId across = growFromTip(plant, {1, 0, 0}, 0.1, 3);
  EXPECT_EQ(bestSuccessor(plant, {back, across}), across);
}

TEST(BestSuccessor, OfARootIsTheThickest) {
  Skeleton plant;
  const NodeId root = plant.add({.radius = 0.1});
  const NodeId thin = plant.add({.position = {0, 0, 1}, .radius = 0.01, .parent = root});
  const NodeId thick = plant.add({.position = {1, 0, 1}, .radius = 0.1, .parent = root});
  EXPECT_EQ(bestSuccessor(plant, {thin, thick}), thick);
}

} // namespace
} // namespace espalier
