#include "core/pipeline/check_table.h"

#include <gtest/gtest.h>

#include <vector>

namespace espalier {
namespace {

TEST(CheckTable, HasTheDefaultsOfTheChecks) {
  std::vector<double> values;
  for (const Option& option : checkTable().descriptions()) {
    EXPECT_FALSE(option.help.empty()) << option.name;
    const double value = option.rule.value({});
    EXPECT_GE(value, option.minimum) << option.name;
    EXPECT_LE(value, option.maximum) << option.name;
    values.push_back(value);
  }
  const CheckOptions made = checkTable().with(values);
  const CheckOptions defaults;
  EXPECT_NEAR(made.sharpTurn, defaults.sharpTurn, 1e-12);
  EXPECT_EQ(made.shortEdge, defaults.shortEdge);
  EXPECT_EQ(made.duplicateShare, defaults.duplicateShare);
  EXPECT_EQ(made.touch, defaults.touch);
  EXPECT_EQ(made.detour, defaults.detour);
  EXPECT_EQ(made.pointReach, defaults.pointReach);
  EXPECT_EQ(made.clusterGap, defaults.clusterGap);
  EXPECT_EQ(made.clusterSize, defaults.clusterSize);
  EXPECT_EQ(made.emptyReach, defaults.emptyReach);
  EXPECT_EQ(made.ownBeside, defaults.ownBeside);
  EXPECT_EQ(made.ownReach, defaults.ownReach);
  EXPECT_EQ(made.ownCount, defaults.ownCount);
  EXPECT_EQ(made.ownLength, defaults.ownLength);
}

} // namespace
} // namespace espalier
