#include "core/base/random.h"
#include "core/simulate/piece_tree.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

using Eigen::Vector3d;

TEST(WoodIndex, FindsTheSameHitsAsLookingAtAllWood) {
  const std::vector<EdgeSolid> wood = woodOf(test::randomPlant(60, 3));
  const WoodIndex index(wood);
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{30 * random.direction(), random.direction()};
    std::optional<WoodHit> expected;
    for (const EdgeSolid& piece : wood)
      if (const auto next = hit(piece, ray); next && (!expected || next->range < expected->range))
        expected = next;
    const std::optional<WoodHit> found = index.firstHit(ray);
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!expected) continue;
    ++hits;
    EXPECT_EQ(found->range, expected->range);
    EXPECT_EQ(found->node, expected->node);
    EXPECT_FALSE(index.firstHit(ray, 0.99 * expected->range));
  }
  EXPECT_GT(hits, 100);
}

TEST(WoodIndex, FindsTheSameDistancesAsLookingAtAllWood) {
  const std::vector<EdgeSolid> wood = woodOf(test::randomPlant(60, 4));
  const WoodIndex index(wood);
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vector3d place = random.uniform(0, 25) * random.direction();
    double expected = 5;
    for (const EdgeSolid& piece : wood)
      expected = std::min(expected, signedDistance(piece, place));
    const double found = index.distance(place, 5);
    if (expected > 0)
      EXPECT_EQ(found, expected);
    else
      EXPECT_LE(found, 0); // inside, how deep does not matter
  }
}

TEST(WoodIndex, SeesWoodAlongTheAxesOfTheFrame) {
  const WoodIndex index(woodOf(test::stick(9)));
  EXPECT_TRUE(index.firstHit({{-5, 0, 4}, {1, 0, 0}})); // in the plane of the sides of boxes
  EXPECT_TRUE(index.firstHit({{0, 0, 20}, {0, 0, -1}}));
}

TEST(WoodIndex, OfNoWoodFindsNothing) {
  const WoodIndex index({});
  EXPECT_FALSE(index.firstHit({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(index.distance({0, 0, 0}, 3), 3);
  EXPECT_TRUE(index.bounds().isEmpty());
}

} // namespace
} // namespace espalier
