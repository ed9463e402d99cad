#include "app/report/report_numbers.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const QChar thinSpace(0x202f);

TEST(ReportNumbers, SetsThousandsApartAndWritesNoExponents) {
  const ReportNumbers numbers("mm");
  EXPECT_EQ(numbers.number(156485.72), QString("156") + thinSpace + "486");
  EXPECT_EQ(numbers.number(1234.56), "1235");
  EXPECT_EQ(numbers.number(0.000123), "0.000123");
  EXPECT_EQ(numbers.number(-12.345), QChar(0x2212) + QString("12.35"));
  EXPECT_EQ(numbers.number(0), "0");
  EXPECT_EQ(numbers.length(12.5), QString("12.50") + thinSpace + "mm");
  EXPECT_EQ(numbers.count(1234567), QString("1") + thinSpace + "234" + thinSpace + "567");
}

TEST(ReportNumbers, WritesWhatWasGivenWithoutZerosAtTheEnd) {
  const ReportNumbers numbers("m");
  EXPECT_EQ(numbers.given(10), "10");
  EXPECT_EQ(numbers.given(0.25), "0.25");
  EXPECT_EQ(numbers.given(100), "100");
  EXPECT_EQ(numbers.givenLength(0.02), QString("0.02") + thinSpace + "m");
  EXPECT_EQ(ReportNumbers("").givenLength(20), "20");
}

TEST(ReportNumbers, SaysByHowMuchOneIsAboveTheOther) {
  const ReportNumbers numbers("m");
  EXPECT_EQ(numbers.difference(3, 2), QString("+50.0") + thinSpace + "%");
  EXPECT_EQ(numbers.difference(1, 2), QChar(0x2212) + QString("50.0") + thinSpace + "%");
  EXPECT_EQ(numbers.difference(2, 2), QString("0.0") + thinSpace + "%");
  EXPECT_EQ(numbers.difference(1, 0), QString::fromUtf8("–"));
  EXPECT_EQ(numbers.difference(0, 0), QString("0.0") + thinSpace + "%");
}

TEST(ReportNumbers, NamesUnitsOfAreasAndVolumes) {
  EXPECT_EQ(ReportNumbers("cm").inUnit("area", 2), QString::fromUtf8("area [cm²]"));
  EXPECT_EQ(ReportNumbers("cm").inUnit("volume", 3), QString::fromUtf8("volume [cm³]"));
  EXPECT_EQ(ReportNumbers("").inUnit("length"), "length");
}

} // namespace
} // namespace espalier
