#include "ui/view/legend.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(Legend, WritesTheEndsOfItsRangeToAHundredthOfIt) {
  EXPECT_EQ(rangeNumber(10.9612, {5.97, 10.96}, "m"), "10.96");
  EXPECT_EQ(rangeNumber(8.23412, {8.1, 8.7}, "m"), "8.234");
  EXPECT_EQ(rangeNumber(0.0213, {0, 0.05}, "%"), "0.0213") << "no length";
  EXPECT_EQ(rangeNumber(0.0213, {0, 0.05}, ""), "0.0213") << "nobody knows the unit";
}

TEST(Legend, WritesLengthsNoFinerThanAMillimeter) {
  EXPECT_EQ(rangeNumber(8.23412, {8.2, 8.25}, "m"), "8.234");
  EXPECT_EQ(rangeNumber(23.412, {20, 25}, "cm"), "23.4");
  EXPECT_EQ(rangeNumber(234.12, {200, 250}, "mm"), "234");
  EXPECT_EQ(rangeNumber(0.00213, {0.002, 0.004}, "m"), "0.0021") << "or both ends would be alike";
}

} // namespace
} // namespace espalier
