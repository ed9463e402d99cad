#include "ui/panels/trait_text.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

std::string areaText(double area, LengthUnit unit) {
  TraitRow row;
  row.kind = TraitKind::area;
  row.value = area;
  return textOf(row, unit).toStdString();
}

TEST(TraitText, OfAnAreaIsInAUnitThatFitsIt) {
  EXPECT_EQ(areaText(24'345'648, LengthUnit::millimeter), "24.3\u202fm²");
  EXPECT_EQ(areaText(0.05, LengthUnit::meter), "500\u202fcm²");
  EXPECT_EQ(areaText(0.25, LengthUnit::centimeter), "25.0\u202fmm²");
  EXPECT_EQ(areaText(12.5, LengthUnit::unknown), "12.5");
}

} // namespace
} // namespace espalier
