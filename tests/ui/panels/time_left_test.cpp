#include "ui/panels/time_left.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(TimeLeft, GoesOnAsTheJobWent) {
  EXPECT_DOUBLE_EQ(secondsLeft(10, 0.25).value(), 30);
  EXPECT_DOUBLE_EQ(secondsLeft(10, 1).value(), 0);
}

TEST(TimeLeft, IsNotGuessedTooEarly) {
  EXPECT_FALSE(secondsLeft(0.5, 0.1));
  EXPECT_FALSE(secondsLeft(10, 0));
}

TEST(TimeLeft, IsShownInWholeSecondsOrMinutes) {
  EXPECT_EQ(describeTimeLeft(11.2), "about 12 s left");
  EXPECT_EQ(describeTimeLeft(0), "about 1 s left");
  EXPECT_EQ(describeTimeLeft(200), "about 3 min left");
  EXPECT_EQ(describeTimeLeft(std::nullopt), "");
}

} // namespace
} // namespace espalier
