#include "core/base/random.h"
#include "core/graph/arborescence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <optional>

namespace espalier {
namespace {

using testing::ElementsAre;

using Links = std::vector<DirectedLink>;

/// What the tree costs; none if it is no tree over all places.
std::optional<double> costOf(const std::vector<int>& chosen, std::uint32_t root,
                             const Links& links) {
  double cost = 0;
  for (std::uint32_t place = 0; place < chosen.size(); ++place) {
    std::uint32_t at = place;
    for (std::size_t steps = 0; at != root; ++steps) {
      if (chosen[at] < 0 || steps > chosen.size()) return std::nullopt;
      if (links[static_cast<std::size_t>(chosen[at])].to != at) return std::nullopt;
      at = links[static_cast<std::size_t>(chosen[at])].from;
    }
    if (place != root) cost += links[static_cast<std::size_t>(chosen[place])].cost;
  }
  return cost;
}

/// The least cost of any tree, by trying them all.
std::optional<double> leastCost(std::uint32_t count, std::uint32_t root, const Links& links) {
  std::vector<int> chosen(count, -1);
  std::optional<double> least;
  const auto tryFrom = [&](const auto& self, std::uint32_t place) -> void {
    if (place == count) {
      const auto cost = costOf(chosen, root, links);
      if (cost && (!least || *cost < *least)) least = cost;
      return;
    }
    if (place == root) return self(self, place + 1);
    for (std::size_t i = 0; i < links.size(); ++i)
      if (links[i].to == place) {
        chosen[place] = static_cast<int>(i);
        self(self, place + 1);
      }
  };
  tryFrom(tryFrom, 0);
  return least;
}

TEST(MinimumArborescence, TakesTheCheapestLinkToEachPlaceWhereThatIsATree) {
  const Links links = {{0, 1, 3}, {0, 2, 5}, {1, 2, 1}, {2, 3, 2}, {0, 3, 9}};
  EXPECT_THAT(minimumArborescence(4, 0, links), ElementsAre(-1, 0, 2, 3));
}

// The cheapest links alone are the cycle 1 -> 2 -> 3 -> 1. Entered at 2 it costs 8 + 1 + 1, at 1 it
// costs 9 + 1 + 1, at 3 it costs 10 + 1 + 1.
TEST(MinimumArborescence, EntersACycleWhereThatCostsLeast) {
  const Links links = {{1, 2, 1}, {2, 3, 1}, {3, 1, 1}, {0, 1, 9}, {0, 2, 8}, {0, 3, 10}};
  EXPECT_THAT(minimumArborescence(4, 0, links), ElementsAre(-1, 2, 4, 1));
}

// A long path of cheap links goes before a short path with a dear one.
TEST(MinimumArborescence, DoesNotMindHowLongThePathIs) {
  const Links links = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {0, 3, 1.5}};
  EXPECT_THAT(minimumArborescence(4, 0, links), ElementsAre(-1, 0, 1, 2));
}

TEST(MinimumArborescence, CostsNoMoreThanAnyOtherTree) {
  Random random(4);
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto count = static_cast<std::uint32_t>(2 + random.below(5));
    const auto root = static_cast<std::uint32_t>(random.below(count));
    Links links;
    for (std::size_t i = 0; i < 3 * count; ++i)
      links.push_back({static_cast<std::uint32_t>(random.below(count)),
                       static_cast<std::uint32_t>(random.below(count)),
                       static_cast<double>(random.below(6))});
    const auto least = leastCost(count, root, links);
    const std::vector<int> chosen = minimumArborescence(count, root, links);
    EXPECT_EQ(costOf(chosen, root, links), least) << "trial " << trial;
    if (least) ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(MinimumArborescence, LeavesOutWhatNoPathLeadsTo) {
  const Links links = {{0, 1, 1}, {2, 3, 1}, {3, 2, 1}, {3, 4, 1}, {2, 0, 1}};
  EXPECT_THAT(minimumArborescence(5, 0, links), ElementsAre(-1, 0, -1, -1, -1));
  EXPECT_THAT(minimumArborescence(1, 0, {}), ElementsAre(-1));
}

TEST(MinimumArborescence, TakesALongChain) {
  constexpr std::uint32_t count = 100'000;
  Links links;
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    links.push_back({i, i + 1, 1});
    links.push_back({i + 1, i, 1});
  }
  const std::vector<int> chosen = minimumArborescence(count, 0, links);
  for (std::uint32_t i = 1; i < count; ++i)
    ASSERT_EQ(links[static_cast<std::size_t>(chosen[i])].from, i - 1);
}

} // namespace
} // namespace espalier
