#include "core/skeleton/prune.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// A stick of 10 with a lateral of `nodes` nodes at half its height.
Skeleton withLateral(int nodes) {
  Skeleton plant = test::stick(10);
  NodeId parent{5};
  for (int i = 1; i <= nodes; ++i)
    parent =
        plant.add({.position = {static_cast<double>(i), 0, 5}, .radius = 0.1, .parent = parent});
  return plant;
}

TEST(WithoutSpurs, RemovesShortEndsOnly) {
  EXPECT_EQ(withoutSpurs(withLateral(1), {.length = 2.5}), test::stick(10));
  EXPECT_EQ(withoutSpurs(withLateral(3), {.length = 2.5}), withLateral(3));
}

TEST(WithoutSpurs, NeverCutsAnUnbranchedPlant) {
  EXPECT_EQ(withoutSpurs(test::stick(3), {.length = 100}), test::stick(3));
  EXPECT_TRUE(withoutSpurs({}, {.length = 100}).isEmpty());
}

// Of a fork of two short arms the first to go makes the other part of the trunk, which stays.
TEST(WithoutSpurs, KeepsTheLongestEnd) {
  Skeleton plant = test::fork(3);
  plant.setPosition(NodeId{3}, {0, 0, 3}); // 2 long; the others are 1.4
  const Skeleton pruned = withoutSpurs(plant, {.length = 100});
  EXPECT_EQ(pruned.size(), 3U);
  EXPECT_TRUE(pruned.contains(NodeId{3}));
}

TEST(WithoutSpurs, AddsTheRadiusOfTheWoodTheyStandOn) {
  Skeleton plant = withLateral(3);
  plant.setRadius(NodeId{5}, 1);
  EXPECT_EQ(withoutSpurs(plant, {.length = 2.5, .radiusShare = 1}).size(), 10U);
}

TEST(WithoutSpurs, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)withoutSpurs(withLateral(1), {.length = 2.5}, progress);
  }));
}

} // namespace
} // namespace espalier
