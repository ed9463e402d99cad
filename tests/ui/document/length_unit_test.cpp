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
  EXPECT_EQ(formatLength(123456, LengthUnit::unknown, 3), "123456");
  EXPECT_EQ(formatLength(0, LengthUnit::unknown), "0");
}

} // namespace
} // namespace espalier
