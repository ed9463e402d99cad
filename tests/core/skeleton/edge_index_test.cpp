#include "core/base/box_tree.h"
#include "core/base/random.h"
#include "core/skeleton/edge_index.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <limits>

namespace espalier {
namespace {

TEST(EdgeIndex, FindsThePlaceAcrossAnEdge) {
  const auto found = EdgeIndex(test::stick(3, 2)).nearest({3, 0, 2.5});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->node, NodeId{2});
  EXPECT_EQ(found->position, Eigen::Vector3d(0, 0, 2.5));
  EXPECT_EQ(found->along, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(found->distance, 3);
}

TEST(EdgeIndex, FindsTheTipBeyondAStick) {
  const auto found = EdgeIndex(test::stick(3)).nearest({0, 3, 6});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->position, Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(found->along, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(found->distance, 5);
}

TEST(EdgeIndex, FindsALoneRootAndNothingInNothing) {
  EXPECT_EQ(EdgeIndex(test::stick(1)).nearest({0, 0, 2})->distance, 2);
  EXPECT_FALSE(EdgeIndex(Skeleton()).nearest({0, 0, 2}));
}

TEST(EdgeIndex, FindsWhatTryingAllEdgesFinds) {
  const Skeleton plant = test::randomPlant(300, 11);
  const EdgeIndex index(plant);
  Random random(12);
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Vector3d place = random.uniform(0, 30) * random.direction();
    double least = std::numeric_limits<double>::infinity();
    for (const NodeId id : plant.ids()) {
      const Eigen::Vector3d end = plant[id].position;
      const Eigen::Vector3d start = plant[id].parent ? plant[*plant[id].parent].position : end;
      const Eigen::Vector3d edge = end - start;
      const double share =
          plant[id].parent ? std::clamp(edge.dot(place - start) / edge.squaredNorm(), 0.0, 1.0) : 0;
      least = std::min(least, (start + share * edge - place).norm());
    }
    EXPECT_NEAR(index.nearest(place)->distance, least, 1e-12);
  }
}

// A thousand that meet at a place, and one of its own.
TEST(BoxTree, PassesOverBoxesOfAGroupThatLieTogether) {
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<std::uint32_t> groups;
  for (int i = 0; i < 1000; ++i) {
    Eigen::AlignedBox3d box(Eigen::Vector3d::Zero());
    box.extend(Eigen::Vector3d(1, 0.001 * i, 0));
    boxes.push_back(box);
    groups.push_back(7);
  }
  boxes.emplace_back(Eigen::Vector3d(0.5, 0, 0));
  groups.push_back(BoxTree::noGroup);
  const BoxTree tree(boxes, groups);
  const auto visits = [&](std::uint32_t but) {
    std::vector<std::size_t> visited;
    const auto note = [&](std::size_t i) { visited.push_back(i); };
    tree.within(boxes.back(), 0, note, but);
    return visited;
  };
  EXPECT_EQ(visits(BoxTree::noGroup).size(), boxes.size());
  EXPECT_EQ(visits(8).size(), boxes.size());
  EXPECT_LT(visits(7).size(), 10U) << "those that lie beside the other";
  EXPECT_EQ(std::ranges::count(visits(7), boxes.size() - 1), 1);
}

TEST(BoxTree, FindsTheBoxesThatTryingAllFinds) {
  Random random(13);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d corner = random.uniform(0, 10) * random.direction();
    boxes.emplace_back(corner, corner + Eigen::Vector3d(random.uniform(), 0, random.uniform()));
  }
  const BoxTree tree(boxes);
  for (const double distance : {0.0, 0.5, 3.0, 50.0}) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].exteriorDistance(boxes[0]) <= distance) expected.push_back(i);
    std::vector<std::size_t> found;
    tree.within(boxes[0], distance, [&](std::size_t i) { found.push_back(i); });
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected));
  }
}

} // namespace
} // namespace espalier
