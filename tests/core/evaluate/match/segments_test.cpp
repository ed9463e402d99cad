#include "core/evaluate/match/segments.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Segments, OfAStickIsTheWholeStick) {
  const auto segments = unbranchedSegments(test::stick(4, 2));
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].nodes.size(), 4U);
  EXPECT_EQ(segments[0].polyline.size(), 4U);
  EXPECT_EQ(segments[0].length, 6);
  EXPECT_EQ(segments[0].parent, std::nullopt);
  EXPECT_EQ(segments[0].box.max(), Eigen::Vector3d(0, 0, 6));
}

TEST(Segments, EndAtABranchingAndStartAtItsPosition) {
  const Skeleton plant = test::fork(2);
  const auto segments = unbranchedSegments(plant);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_THAT(segments[0].nodes, ElementsAre(test::forkRoot, test::forkTop));
  EXPECT_THAT(segments[1].nodes, ElementsAre(NodeId{2}));
  EXPECT_EQ(segments[1].polyline.front(), plant[test::forkTop].position);
  EXPECT_NEAR(segments[1].length, std::sqrt(2.0), 1e-12);
  EXPECT_EQ(segments[1].parent, 0U);
  EXPECT_EQ(segments[2].parent, 0U);
}

TEST(Segments, AreSplitByASpur) {
  Skeleton plant = test::stick(5);
  plant.add({.position = {0.1, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  const auto segments = unbranchedSegments(plant);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[0].length, 2); // up to the spur
  EXPECT_EQ(segments[1].length, 2); // beyond it: a successor comes before branches
  EXPECT_EQ(segments[2].length, 0.1);
}

TEST(Segments, StartAtEachRootAndHoldEachNodeOnce) {
  const Skeleton plant = test::randomPlant(200, 7);
  std::vector<int> uses(plant.idEnd(), 0);
  std::size_t roots = 0;
  for (const Segment& segment : unbranchedSegments(plant)) {
    if (!segment.parent) ++roots;
    for (const NodeId id : segment.nodes)
      ++uses[indexOf(id)];
  }
  EXPECT_EQ(roots, plant.roots().size());
  EXPECT_THAT(uses, testing::Each(1));
}

TEST(Segments, OfNothingAreNone) {
  EXPECT_THAT(unbranchedSegments({}), IsEmpty());
}

TEST(VertexHausdorff, IsTheGreatestDistanceToANearestVertex) {
  const std::vector<Eigen::Vector3d> stick = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}};
  const std::vector<Eigen::Vector3d> beside = {{3, 0, 0}, {3, 0, 1}, {3, 0, 2}};
  const std::vector<Eigen::Vector3d> half = {{0, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(vertexHausdorff(stick, beside), 3);
  EXPECT_EQ(vertexHausdorff(stick, half), 1);
  EXPECT_EQ(vertexHausdorff(half, stick), 1);
  EXPECT_EQ(vertexHausdorff(stick, stick), 0);
}

} // namespace
} // namespace espalier
