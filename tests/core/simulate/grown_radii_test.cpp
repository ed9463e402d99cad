#include "core/base/error.h"
#include "core/simulate/grown_radii.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

// 100 edges, each as long as an apex weighs: node i carries 101 - i, the node-count pipe model.
TEST(GrownRadii, AreTheNodeCountPipeModelWhenNodesAreEvenlySpaced) {
  const double apex = 0.01;
  const Skeleton plant =
      withGrownRadii(test::stick(101, 19 * apex), {.baseRadius = 0.1, .apexRadius = apex});
  const double exponent = std::log(10.0) / std::log(101.0);
  for (const NodeId id : plant.ids()) {
    const double carried = 101 - static_cast<double>(indexOf(id));
    EXPECT_NEAR(plant[id].radius, apex * std::pow(carried, exponent), 1e-9);
  }
}

TEST(GrownRadii, AreTheTwoGivenOnesAtTheBaseAndTheApices) {
  const Skeleton plant = withGrownRadii(test::fork(3), {.baseRadius = 0.2, .apexRadius = 0.02});
  EXPECT_NEAR(plant[test::forkRoot].radius, 0.2, 1e-12);
  for (const NodeId apex : plant.children(test::forkTop))
    EXPECT_NEAR(plant[apex].radius, 0.02, 1e-12);
}

TEST(GrownRadii, NeverGrowTowardsTheApexHoweverTheySpread) {
  const Skeleton plant =
      withGrownRadii(test::randomPlant(300, 8),
                     {.baseRadius = 0.5, .apexRadius = 0.01, .spread = 0.8, .flare = 1, .seed = 4});
  for (const NodeId id : plant.ids()) {
    EXPECT_GT(plant[id].radius, 0);
    if (plant[id].parent) {
      EXPECT_LE(plant[id].radius, plant[*plant[id].parent].radius);
    }
  }
}

TEST(GrownRadii, FlareAtTheGroundOnly) {
  const GrownRadiusOptions straight{.baseRadius = 0.1, .apexRadius = 0.01};
  GrownRadiusOptions flared = straight;
  flared.flare = 0.5;
  const Skeleton a = withGrownRadii(test::stick(11), straight);
  const Skeleton b = withGrownRadii(test::stick(11), flared);
  EXPECT_NEAR(b[NodeId{0}].radius, 1.5 * a[NodeId{0}].radius, 1e-12);
  EXPECT_NEAR(b[NodeId{10}].radius, a[NodeId{10}].radius, 1e-12);
}

TEST(GrownRadii, RefuseRadiiThatAreNotOrdered) {
  EXPECT_THROW(
      static_cast<void>(withGrownRadii(test::stick(3), {.baseRadius = 0.1, .apexRadius = 0.2})),
      Error);
  EXPECT_THROW(static_cast<void>(withGrownRadii(test::stick(3), {.baseRadius = 0.1})), Error);
}

} // namespace
} // namespace espalier
