#include "ui/document/length_unit.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(LengthUnit, IsFoundAgainByItsSymbol) {
  for (const LengthUnit unit :
       {LengthUnit::unknown, LengthUnit::millimeter, LengthUnit::centimeter, LengthUnit::meter})
    EXPECT_EQ(unitOfSymbol(symbol(unit)), unit);
  EXPECT_EQ(unitOfSymbol("furlong"), LengthUnit::unknown);
}

TEST(LengthUnit, FollowsANumberRoundedToItsSize) {
  EXPECT_EQ(formatLength(12.3456, LengthUnit::millimeter, 3), QString::fromUtf8("12.3\u202fmm"));
  EXPECT_EQ(formatLength(0.00123456, LengthUnit::meter, 3), QString::fromUtf8("0.00123\u202fm"));
  EXPECT_EQ(formatLength(123456, LengthUnit::unknown, 3), QString::fromUtf8("123\u202f456"));
  EXPECT_EQ(formatLength(0, LengthUnit::unknown), "0");
}

TEST(FormatCount, GroupsDigitsInThrees) {
  EXPECT_EQ(formatCount(7), "7");
  EXPECT_EQ(formatCount(100), "100");
  EXPECT_EQ(formatCount(147989), QString::fromUtf8("147\u202f989"));
  EXPECT_EQ(formatCount(1234567), QString::fromUtf8("1\u202f234\u202f567"));
}

TEST(FormatBytes, HasThreeDigitsAndTheLargestUnitThatFits) {
  EXPECT_EQ(formatBytes(0), "0 bytes");
  EXPECT_EQ(formatBytes(1), "1 byte");
  EXPECT_EQ(formatBytes(999), "999 bytes");
  EXPECT_EQ(formatBytes(1000), "1.00 kB");
  EXPECT_EQ(formatBytes(33'887'400), "33.9 MB");
  EXPECT_EQ(formatBytes(2'500'000'000), "2.50 GB");
}

} // namespace
} // namespace espalier
