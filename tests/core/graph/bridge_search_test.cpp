#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/graph/bridge_search.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

/// Clumps of many points, some of which lie on each other.
struct Clumps {
  Eigen::Matrix3Xf points;
  std::vector<std::uint32_t> componentOf;

  Clumps(std::uint32_t clumps, std::uint32_t each) {
    Random random(5);
    points.resize(3, clumps * each);
    for (std::uint32_t c = 0; c < clumps; ++c) {
      const Eigen::Vector3d middle = 10 * random.uniform() * random.direction();
      for (std::uint32_t i = 0; i < each; ++i) {
        const Eigen::Vector3d place = middle + 0.3 * random.uniform() * random.direction();
        points.col(c * each + i) = (8 * place).array().round().cast<float>() / 8; // ties
        componentOf.push_back(c);
      }
    }
  }
};

std::vector<Bridge> byComparingAll(const Clumps& clumps, std::size_t count, float widest) {
  std::vector<Bridge> best(count);
  for (std::uint32_t i = 0; i < clumps.componentOf.size(); ++i)
    for (std::uint32_t j = 0; j < clumps.componentOf.size(); ++j) {
      if (clumps.componentOf[i] == 0 || clumps.componentOf[i] == clumps.componentOf[j]) continue;
      const float squared = (clumps.points.col(i) - clumps.points.col(j)).squaredNorm();
      if (squared > widest * widest) continue;
      Bridge& shortest = best[clumps.componentOf[i]];
      shortest = std::min(shortest, Bridge{squared, i, j});
    }
  return best;
}

void expectSame(const std::vector<Bridge>& found, const std::vector<Bridge>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].squaredLength, expected[i].squaredLength) << i;
    EXPECT_EQ(found[i].from, expected[i].from) << i;
    EXPECT_EQ(found[i].to, expected[i].to) << i;
  }
}

TEST(BridgeSearch, FindsWhatComparingAllPointsFinds) {
  const Clumps clumps(30, 40);
  BridgeSearch search(clumps.points);
  for (const float widest : {1e9F, 3.0F, 0.1F})
    expectSame(search.shortest(clumps.componentOf, 30, widest, {}),
               byComparingAll(clumps, 30, widest));
}

TEST(BridgeSearch, FollowsComponentsThatAreJoined) {
  Clumps clumps(30, 40);
  BridgeSearch search(clumps.points);
  (void)search.shortest(clumps.componentOf, 30, 1e9F, {});
  for (std::uint32_t& component : clumps.componentOf)
    component /= 4;
  expectSame(search.shortest(clumps.componentOf, 8, 1e9F, {}), byComparingAll(clumps, 8, 1e9F));
}

TEST(BridgeSearch, IsTheSameOnAnyNumberOfThreads) {
  const Clumps clumps(60, 100);
  BridgeSearch search(clumps.points);
  const std::vector<Bridge> onMany = search.shortest(clumps.componentOf, 60, 1e9F, {});
  const ThreadLimit limit(1);
  expectSame(search.shortest(clumps.componentOf, 60, 1e9F, {}), onMany);
}

TEST(BridgeSearch, OfOnePlaceFindsBridgesOfNoLength) {
  const Eigen::Matrix3Xf points = Eigen::Matrix3Xf::Ones(3, 100);
  std::vector<std::uint32_t> componentOf(100, 0);
  std::fill(componentOf.begin() + 50, componentOf.end(), 1U);
  const std::vector<Bridge> found = BridgeSearch(points).shortest(componentOf, 2, 1, {});
  EXPECT_FALSE(found[0].exists()) << "not looked for";
  ASSERT_TRUE(found[1].exists());
  EXPECT_EQ(found[1].squaredLength, 0);
}

} // namespace
} // namespace espalier
