#include "ui/document/number_scale.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(NumberScale, StepsByOneTwoAndFive) {
  EXPECT_DOUBLE_EQ(roundStep(1), 1);
  EXPECT_DOUBLE_EQ(roundStep(1.99), 1);
  EXPECT_DOUBLE_EQ(roundStep(4.9), 2);
  EXPECT_DOUBLE_EQ(roundStep(5), 5);
  EXPECT_DOUBLE_EQ(roundStep(0.07), 0.05);
  EXPECT_DOUBLE_EQ(roundStep(1000), 1000);
}

TEST(NumberScale, WritesAsManyDigitsAsTheStepNeeds) {
  EXPECT_EQ(numberAtStep(0.25, 0.05), "0.25");
  EXPECT_EQ(numberAtStep(12, 2), "12");
  EXPECT_EQ(numberAtStep(-0.0001, 0.1), QString::fromUtf8("−0.0")) << "rounded, but not nothing";
  EXPECT_EQ(numberAtStep(-1e-17, 0.1), "0.0");
  EXPECT_EQ(numberAtStep(-1234567, 1000),
            QString::fromUtf8("−1 234 567").replace(' ', QChar(0x202f)));
}

TEST(NumberScale, CountsBothEndsOfARange) {
  const std::vector<double> numbers = multiplesOf(0.1, 0, 0.3);
  ASSERT_EQ(numbers.size(), 4U);
  EXPECT_DOUBLE_EQ(numbers.back(), 0.3);
  EXPECT_TRUE(multiplesOf(10, 1, 9).empty());
  EXPECT_EQ(multiplesOf(5, -7, 7).front(), -5);
}

} // namespace
} // namespace espalier
