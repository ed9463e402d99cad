#include "core/evaluate/traits/axis_traits.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

/// A stem of 10 whose radius falls from 2 to 1, with straight branches of 1 and 3 at the heights 2
/// and 6, and a crooked one of 5 at 8, which bears a twig of 1 at its middle.
Skeleton tree() {
  Skeleton plant = test::stick(11);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 2 - plant[id].position.z() / 10);
  const auto branch = [&](NodeId on, const Eigen::Vector3d& offset, double radius) {
    return plant.add({.position = plant[on].position + offset,
                      .radius = radius,
                      .parent = on,
                      .edge = EdgeType::branching});
  };
  branch(NodeId{2}, {1, 0, 0}, 0.5);
  branch(NodeId{6}, {3, 0, 0}, 0.3);
  const NodeId first = branch(NodeId{8}, {0, 2.5, 0}, 0);
  plant.add({.position = plant[first].position + Eigen::Vector3d(2.5, 0, 0),
             .radius = 0.1,
             .parent = first});
  branch(first, {0, 0, 1}, 0.2);
  return plant;
}

TEST(AxisTraits, OfASmallTreeAreKnownOnPaper) {
  const std::vector<AxisTraits> found = axisTraits(tree());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].count, 1U);
  EXPECT_NEAR(found[0].meanLength, 10, 1e-12);
  EXPECT_EQ(found[0].lengthDeviation, 0);
  EXPECT_EQ(found[0].meanInsertion, 0);
  EXPECT_NEAR(found[0].meanBaseRadius, 2, 1e-12);
  EXPECT_NEAR(found[0].meanTopRadius, 1, 1e-12);
  EXPECT_EQ(found[1].count, 3U);
  EXPECT_NEAR(found[1].meanLength, 3, 1e-12);
  EXPECT_NEAR(found[1].lengthDeviation, 2, 1e-12) << "of 1, 3 and 5";
  EXPECT_NEAR(found[1].medianLength, 3, 1e-12);
  EXPECT_NEAR(found[1].meanChord, (4 + 2.5 * std::sqrt(2.0)) / 3, 1e-12);
  EXPECT_NEAR(found[1].meanInsertion, (0.2 + 0.6 + 0.8) / 3, 1e-12);
  EXPECT_NEAR(found[1].meanBaseRadius, 0.4, 1e-12) << "of the two that have one";
  EXPECT_NEAR(found[1].meanTopRadius, 0.3, 1e-12);
  EXPECT_EQ(found[2].count, 1U);
  EXPECT_NEAR(found[2].meanInsertion, 0.5, 1e-12);
}

TEST(AxisTraits, TakeTheMeanOfTheTwoInTheMiddleForTheMedian) {
  EXPECT_NEAR(axisTraits(test::fork(3))[1].medianLength, std::sqrt(2.0), 1e-12);
  Skeleton plant = test::fork(3);
  plant.setPosition(NodeId{4}, {0, 0, 4}); // 3 above the fork
  EXPECT_NEAR(axisTraits(plant)[1].medianLength, (3 + std::sqrt(2.0)) / 2, 1e-12);
  EXPECT_TRUE(axisTraits({}).empty());
}

TEST(StemTraits, AreItsLengthAndWhereItBearsBranches) {
  const StemTraits found = stemTraits(tree());
  EXPECT_NEAR(found.length, 10, 1e-12);
  EXPECT_NEAR(found.lowestBranch, 2, 1e-12);
  EXPECT_NEAR(found.highestBranch, 8, 1e-12);
  EXPECT_NEAR(found.baseRadius, 2, 1e-12);
  EXPECT_NEAR(found.topRadius, 1, 1e-12);
  const StemTraits bare = stemTraits(test::stick(3));
  EXPECT_EQ(bare.lowestBranch, 0);
  EXPECT_EQ(bare.highestBranch, 0);
  EXPECT_EQ(stemTraits({}).length, 0);
}

TEST(StemOf, IsThatOfTheLongestTree) {
  Skeleton two = test::stick(3);
  const NodeId foot = two.add({.position = {5, 0, 0}});
  const NodeId top = two.add({.position = {5, 0, 9}, .parent = foot});
  EXPECT_EQ(stemOf(two), (Axis{foot, top}));
  EXPECT_TRUE(stemOf({}).empty());
}

} // namespace
} // namespace espalier
