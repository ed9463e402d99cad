#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

TEST(SimulatedPlants, AreScannedNearlyWhole) {
  for (const test::SimulatedPlant* plant : {&test::simulatedTree(), &test::simulatedHerb()}) {
    ASSERT_EQ(static_cast<std::size_t>(plant->cloud.size()), plant->scan.nodes.size());
    std::vector<bool> seen(plant->truth.idEnd());
    for (const auto& node : plant->scan.nodes)
      if (node) seen[indexOf(*node)] = true;
    const auto edges = static_cast<double>(plant->truth.size() - 1);
    EXPECT_GT(static_cast<double>(std::count(seen.begin(), seen.end(), true)), 0.9 * edges);
  }
}

} // namespace
} // namespace espalier
