#include "core/base/error.h"
#include "core/base/random.h"
#include "core/evaluate/match/edit_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stop_token>

namespace espalier {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// The lowest that carries both, or is one of them; none: the roots differ.
std::optional<std::size_t> lca(const ParentList& tree, std::size_t a, std::size_t b) {
  for (std::optional<std::size_t> up = a; up; up = tree[*up])
    for (std::optional<std::size_t> other = b; other; other = tree[*other])
      if (up == other) return up;
  return {};
}

bool isBelow(const ParentList& tree, std::optional<std::size_t> carrier, std::size_t vertex) {
  if (!carrier) return true; // what carries the roots
  for (std::optional<std::size_t> up = tree[vertex]; up; up = tree[*up])
    if (up == carrier) return true;
  return false;
}

/// The rules of a constrained mapping, as K. Zhang states them.
bool isConstrained(const ParentList& a, const ParentList& b, const Pairs& pairs) {
  for (const auto& [a1, b1] : pairs)
    for (const auto& [a2, b2] : pairs) {
      if ((a1 == a2) != (b1 == b2)) return false;
      if (isBelow(a, a1, a2) != isBelow(b, b1, b2)) return false;
      for (const auto& [a3, b3] : pairs)
        if (isBelow(a, lca(a, a1, a2), a3) != isBelow(b, lca(b, b1, b2), b3)) return false;
    }
  return true;
}

/// The distance by trying all mappings.
double leastOfAll(const ParentList& a, const ParentList& b, const EditCosts& costs,
                  std::size_t next = 0, const Pairs& pairs = {}) {
  if (next == a.size()) {
    if (!isConstrained(a, b, pairs)) return std::numeric_limits<double>::infinity();
    double cost = 0;
    for (const double each : costs.removal)
      cost += each;
    for (const double each : costs.insertion)
      cost += each;
    for (const auto& [i, j] : pairs)
      cost += costs.substitution(i, j) - costs.removal[i] - costs.insertion[j];
    return cost;
  }
  double least = leastOfAll(a, b, costs, next + 1, pairs);
  for (std::size_t j = 0; j < b.size(); ++j) {
    Pairs more = pairs;
    more.emplace_back(next, j);
    least = std::min(least, leastOfAll(a, b, costs, next + 1, more));
  }
  return least;
}

ParentList randomTree(Random& random, std::size_t size, std::size_t roots = 1) {
  ParentList parents(size);
  for (std::size_t i = roots; i < size; ++i)
    parents[i] = random.below(i);
  return parents;
}

EditCosts randomCosts(Random& random, std::size_t a, std::size_t b) {
  EditCosts costs;
  for (std::size_t i = 0; i < a; ++i)
    costs.removal.push_back(random.uniform(0.1, 2));
  for (std::size_t j = 0; j < b; ++j)
    costs.insertion.push_back(random.uniform(0.1, 2));
  std::vector<double> table;
  for (std::size_t i = 0; i < a; ++i)
    for (std::size_t j = 0; j < b; ++j)
      table.push_back(random.uniform(0, costs.removal[i] + costs.insertion[j]));
  costs.substitution = [table, b](std::size_t i, std::size_t j) { return table[i * b + j]; };
  return costs;
}

EditCosts unitCosts(std::size_t a, std::size_t b) {
  return {.removal = std::vector<double>(a, 1),
          .insertion = std::vector<double>(b, 1),
          .substitution = [](std::size_t, std::size_t) { return 0; }};
}

EditDistance unitDistance(const ParentList& a, const ParentList& b) {
  return editDistance(a, b, unitCosts(a.size(), b.size()));
}

// A trunk with three shoots, the last of which carries two.
const ParentList bush = {{}, 0, 0, 0, 3, 3};

TEST(EditDistance, IsTheLeastOverAllConstrainedMappings) {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    const ParentList a = randomTree(random, 1 + random.below(4), 1 + random.below(2));
    const ParentList b = randomTree(random, 1 + random.below(4), 1 + random.below(2));
    const EditCosts costs = randomCosts(random, a.size(), b.size());
    EXPECT_NEAR(editDistance(a, b, costs).distance, leastOfAll(a, b, costs), 1e-12)
        << "round " << round;
  }
}

TEST(EditDistance, MatchesAddUpToTheDistanceByTheRules) {
  Random random(8);
  for (int round = 0; round < 40; ++round) {
    const ParentList a = randomTree(random, 30);
    const ParentList b = randomTree(random, 25, 3);
    const EditCosts costs = randomCosts(random, a.size(), b.size());
    const EditDistance found = editDistance(a, b, costs);
    double sum = found.removingAll + found.insertingAll;
    Pairs pairs;
    for (const EditMatch& match : found.matches) {
      ASSERT_EQ(match.first.size(), 1U);
      ASSERT_EQ(match.second.size(), 1U);
      pairs.emplace_back(match.first[0], match.second[0]);
      sum += match.cost - costs.removal[match.first[0]] - costs.insertion[match.second[0]];
    }
    EXPECT_NEAR(sum, found.distance, 1e-9);
    EXPECT_TRUE(isConstrained(a, b, pairs)) << "round " << round;
  }
}

TEST(EditDistance, OfATreeFromItselfIsNothing) {
  const EditDistance found = unitDistance(bush, bush);
  EXPECT_EQ(found.distance, 0);
  EXPECT_EQ(found.similarity(), 1);
  EXPECT_EQ(found.matches.size(), bush.size());
}

TEST(EditDistance, OrderOfSiblingsIsNothing) {
  const ParentList turned = {{}, 0, 0, 0, 1, 1};
  EXPECT_EQ(unitDistance(bush, turned).distance, 0);
}

TEST(EditDistance, IsSymmetric) {
  Random random(9);
  for (int round = 0; round < 20; ++round) {
    const ParentList a = randomTree(random, 20);
    const ParentList b = randomTree(random, 15);
    EXPECT_EQ(unitDistance(a, b).distance, unitDistance(b, a).distance);
  }
}

TEST(EditDistance, CountsWhatComesAndGoes) {
  const ParentList without = {{}, 0, 0, 2, 2}; // one shoot less
  EXPECT_EQ(unitDistance(bush, without).distance, 1);
  const ParentList between = {{}, 0, 1, 1, 1, 4, 4}; // a vertex between trunk and shoots
  EXPECT_EQ(unitDistance(bush, between).distance, 1);
  EXPECT_EQ(unitDistance(bush, {}).distance, 6) << "all is removed";
  EXPECT_EQ(unitDistance({}, bush).distance, 6);
  EXPECT_EQ(unitDistance({}, {}).similarity(), 1);
}

// What ended on its own and in the middle of the trunk cannot come together again.
TEST(EditDistance, TakesDisjointSubtreesForDisjointSubtreesOnly) {
  const ParentList a = {{}, 0, 0, 0};    // three siblings
  const ParentList b = {{}, 0, 0, 1, 1}; // two of them on one of their own
  EXPECT_EQ(unitDistance(a, b).distance, 3) << "an unconstrained mapping would need 1";
}

TEST(EditDistance, ManyChildrenAreAssignedAtLeastCost) {
  const ParentList star = [] {
    ParentList parents(11);
    std::fill(parents.begin() + 1, parents.end(), 0);
    return parents;
  }();
  EditCosts costs = unitCosts(star.size(), star.size());
  costs.substitution = [](std::size_t i, std::size_t j) {
    return i == 0 || j == 0 ? (i == j ? 0 : 2) : (i + j == 11 ? 0.125 : 1.5);
  };
  const EditDistance found = editDistance(star, star, costs);
  EXPECT_EQ(found.distance, 10 * 0.125);
  EXPECT_EQ(found.matches.size(), 11U);
}

TEST(EditDistance, MergesAPathIntoOneAndSplitsOneIntoAPath) {
  const ParentList path = {{}, 0, 1, 1, 1}; // a trunk in two pieces with three shoots
  const ParentList whole = {{}, 0, 0, 0};
  EditCosts costs = unitCosts(path.size(), whole.size());
  costs.merge = [](std::span<const std::size_t> parts, std::size_t j) {
    return parts.size() == 2 && parts[0] == 0 && parts[1] == 1 && j == 0 ? 0.25 : 9.0;
  };
  const EditDistance merged = editDistance(path, whole, costs);
  EXPECT_EQ(merged.distance, 0.25);
  ASSERT_EQ(merged.matches.size(), 4U);
  EXPECT_EQ(merged.matches[0], (EditMatch{{0, 1}, {0}, 0.25}));

  EditCosts back = unitCosts(whole.size(), path.size());
  back.split = [&](std::size_t i, std::span<const std::size_t> parts) {
    return costs.merge(parts, i);
  };
  const EditDistance split = editDistance(whole, path, back);
  EXPECT_EQ(split.distance, 0.25);
  EXPECT_EQ(split.matches[0], (EditMatch{{0}, {0, 1}, 0.25}));
}

// A spur on the path is removed when the path around it is merged.
TEST(EditDistance, MergingPaysForWhatIsAttachedBeside) {
  const ParentList spurred = {{}, 0, 0, 2, 2}; // piece, spur, piece, and two shoots
  const ParentList whole = {{}, 0, 0};
  EditCosts costs = unitCosts(spurred.size(), whole.size());
  costs.substitution = [](std::size_t i, std::size_t j) { return i >= 3 && j >= 1 ? 0.0 : 2.0; };
  costs.merge = [](std::span<const std::size_t> parts, std::size_t j) {
    return parts[0] == 0 && parts.back() == 2 && j == 0 ? 0.0 : 9.0;
  };
  EXPECT_EQ(editDistance(spurred, whole, costs).distance, 1);
}

TEST(EditDistance, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)editDistance(bush, bush, unitCosts(6, 6), Progress(source.get_token(), {})),
               Cancelled);
}

TEST(EditDistance, RefusesWhatDoesNotFitIntoMemory) {
  ParentList much(20'000);
  EXPECT_THROW((void)editDistance(much, much, {}), Error);
}

} // namespace
} // namespace espalier
