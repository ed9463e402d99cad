#include "core/evaluate/study/perturbation.h"
#include "core/evaluate/traits/strahler.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

TEST(Strahler, OfAForkIsTwo) {
  const std::vector<int> numbers = strahlerNumbers(test::fork(2));
  EXPECT_EQ(numbers, (std::vector{2, 2, 1, 1}));
  const auto orders = strahlerOrders(test::fork(2));
  ASSERT_EQ(orders.size(), 2U);
  EXPECT_EQ(orders[0].streams, 2U);
  EXPECT_NEAR(orders[0].length, 2 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(orders[1].streams, 1U);
  EXPECT_EQ(orders[1].length, 1);
}

// A twig on a trunk that carries a fork does not raise it: 2 and 1 make 2, 2 and 2 make 3.
TEST(Strahler, RisesOnlyWhereEqualsMeet) {
  Skeleton plant = test::fork(2);
  const NodeId twig = plant.add({.position = {1, 0, 0}, .parent = test::forkRoot});
  EXPECT_EQ(strahlerNumbers(plant)[0], 2);
  plant.add({.position = {2, 0, 1}, .parent = twig});
  plant.add({.position = {2, 0, -1}, .parent = twig, .edge = EdgeType::branching});
  EXPECT_EQ(strahlerNumbers(plant)[0], 3);
  EXPECT_EQ(strahlerOrders(plant)[1].streams, 2U);
}

TEST(Strahler, OfAStickOrNothingIsSimple) {
  EXPECT_EQ(strahlerNumbers(test::stick(3)), (std::vector{1, 1, 1}));
  EXPECT_EQ(strahlerOrders(test::stick(3)).front().length, 2);
  EXPECT_EQ(strahlerOrders(test::stick(1)).front().streams, 1U);
  EXPECT_TRUE(strahlerOrders({}).empty());
}

TEST(Strahler, DoesNotDependOnNodesWithinEdgesOrEdgeTypes) {
  const auto coarse = strahlerOrders(test::bush());
  Skeleton other = test::withMiddleNodes(test::bush());
  for (const NodeId id : other.ids())
    other.setEdge(id, EdgeType::branching);
  const auto fine = strahlerOrders(other);
  ASSERT_EQ(fine.size(), coarse.size());
  for (std::size_t k = 0; k < fine.size(); ++k) {
    EXPECT_EQ(fine[k].streams, coarse[k].streams);
    EXPECT_NEAR(fine[k].length, coarse[k].length, 1e-9);
  }
}

TEST(Strahler, OfKnownPlantsIsTheKnownOne) {
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  EXPECT_EQ(strahlerOrders(test::readTabStructure(expert)).size(), 5U);
  EXPECT_EQ(strahlerOrders(test::readTabStructure(automatic)).size(), 6U);
}

} // namespace
} // namespace espalier
