#include "core/base/text.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <sstream>

namespace espalier {
namespace {

TEST(NumberIn, ReadsWholeNumbersOnly) {
  EXPECT_EQ(numberIn("12"), 12.0);
  EXPECT_EQ(numberIn("+1.5"), 1.5);
  EXPECT_EQ(numberIn("-3e-4"), -3e-4);
  EXPECT_TRUE(std::isnan(*numberIn("nan")));
  EXPECT_EQ(numberIn("-inf"), -std::numeric_limits<double>::infinity());
  for (const char* text : {"", "+", "-", "+-1", "1 ", " 1", "1,5", "abc", "1x", "0x10"})
    EXPECT_EQ(numberIn(text), std::nullopt) << text;
}

TEST(NumberIn, RoundsWhatADoubleCannotHold) {
  EXPECT_EQ(numberIn("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(numberIn("-1e999"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(numberIn("1e-999"), 0.0);
  EXPECT_EQ(numberIn("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(numberIn("1" + std::string(400, '0')), std::numeric_limits<double>::infinity());
}

TEST(PlainDecimal, ReadsBackAsTheSameDoubleAndHasNoExponent) {
  for (const double value :
       {0.1, -0.0, 1e22, 1e-7, 5e-324, 1.7976931348623157e308, 156485.72, 1.0 / 3}) {
    const std::string text = plainDecimal(value);
    EXPECT_EQ(numberIn(text), value) << text;
    EXPECT_EQ(std::signbit(*numberIn(text)), std::signbit(value)) << text;
    EXPECT_EQ(text.find_first_of("eE"), std::string::npos) << text;
  }
  EXPECT_EQ(plainDecimal(0.1), "0.1");
}

TEST(LineReader, TakesAllEndsOfLinesAndCountsLines) {
  LineReader lines("\xEF\xBB\xBF"
                   "one\r\n\ntwo");
  EXPECT_EQ(lines.next(), "one");
  EXPECT_EQ(lines.next(), "");
  EXPECT_EQ(lines.next(), "two");
  EXPECT_EQ(lines.number(), 3U);
  EXPECT_EQ(lines.next(), std::nullopt);
}

TEST(NextWord, TakesWordsOffTheFront) {
  std::string_view rest = "  a\t bc ";
  EXPECT_EQ(nextWord(rest), "a");
  EXPECT_EQ(nextWord(rest), "bc");
  EXPECT_EQ(nextWord(rest), "");
}

TEST(InQuotes, KeepsMessagesOnOneLineAndShort) {
  EXPECT_EQ(inQuotes("a\nb"), "'a?b'");
  EXPECT_LT(inQuotes(std::string(1000, 'x')).size(), 60U);
}

TEST(ReadAll, ReportsHowFarItIsAndStops) {
  std::string text;
  text.resize(50'000'000, 'x');
  std::istringstream in(text);
  std::vector<double> fractions;
  const Progress progress(
      {}, [&](double fraction, std::string_view) { fractions.push_back(fraction); });
  EXPECT_EQ(readAll(in, progress).size(), text.size());
  EXPECT_GT(fractions.size(), 2U);

  std::stop_source stop;
  stop.request_stop();
  std::istringstream again(text);
  EXPECT_THROW((void)readAll(again, Progress(stop.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
