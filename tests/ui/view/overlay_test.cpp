#include "ui/view/legend.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(roundLength(1), 1);
  EXPECT_DOUBLE_EQ(roundLength(1.99), 1);
  EXPECT_DOUBLE_EQ(roundLength(2), 2);
  EXPECT_DOUBLE_EQ(roundLength(4.9), 2);
  EXPECT_DOUBLE_EQ(roundLength(5), 5);
  EXPECT_DOUBLE_EQ(roundLength(99), 50);
  EXPECT_DOUBLE_EQ(roundLength(1000), 1000);
  EXPECT_DOUBLE_EQ(roundLength(0.003), 0.002);
}

} // namespace
} // namespace espalier
