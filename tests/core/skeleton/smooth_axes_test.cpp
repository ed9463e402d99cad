#include "core/skeleton/smooth_axes.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

Skeleton zigzag() {
  Skeleton plant = test::stick(7);
  for (std::uint32_t i = 1; i < 7; i += 2)
    plant.setPosition(NodeId{i}, {1, 0, static_cast<double>(i)});
  return plant;
}

TEST(WithSmoothAxes, MovesNodesTowardsTheMeanOfTheirNeighbors) {
  const Skeleton half = withSmoothAxes(zigzag(), 0.5);
  for (std::uint32_t i = 1; i < 6; ++i)
    EXPECT_LT((half[NodeId{i}].position - Eigen::Vector3d(0.5, 0, i)).norm(), 1e-12);
  EXPECT_EQ(half[NodeId{0}], zigzag()[NodeId{0}]);
  EXPECT_EQ(half[NodeId{6}], zigzag()[NodeId{6}]);
}

TEST(WithSmoothAxes, AsksForNothingWithoutAShareOrARound) {
  EXPECT_EQ(withSmoothAxes(zigzag(), 0), zigzag());
  EXPECT_EQ(withSmoothAxes(zigzag(), 1, 0), zigzag());
  EXPECT_TRUE(withSmoothAxes({}, 1).isEmpty());
}

TEST(WithSmoothAxes, LeavesStraightAxesAndTheFootOfBranches) {
  EXPECT_EQ(withSmoothAxes(test::stick(9), 1, 5), test::stick(9));
  EXPECT_EQ(withSmoothAxes(test::fork(2), 0.5)[NodeId{3}], test::fork(2)[NodeId{3}]);
}

} // namespace
} // namespace espalier
