#include "ui/view/color_map.h"
#include "ui/view/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace espalier {
namespace {

// By the weights of sRGB.
double luminance(const Color& color) {
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

TEST(ColorMap, GetsLighterFromEndToEndIfSequential) {
  for (const ColorMap map : {ColorMap::viridis, ColorMap::cividis, ColorMap::gray})
    for (const bool dark : {false, true})
      for (int i = 1; i <= 20; ++i)
        EXPECT_GT(luminance(colorOf(map, i / 20.0, dark)),
                  luminance(colorOf(map, (i - 1) / 20.0, dark)));
}

TEST(ColorMap, IsNeutralInTheMiddleIfDiverging) {
  for (const bool dark : {false, true}) {
    const Color middle = colorOf(ColorMap::diverging, 0.5, dark);
    EXPECT_NEAR(middle[0], middle[2], 6);
    EXPECT_GT(colorOf(ColorMap::diverging, 0, dark)[2], colorOf(ColorMap::diverging, 0, dark)[0]);
    EXPECT_GT(colorOf(ColorMap::diverging, 1, dark)[0], colorOf(ColorMap::diverging, 1, dark)[2]);
  }
}

// Relative luminance and contrast as WCAG 2.1 has them; 3 is what it asks for graphics.
double contrast(const Color& a, const Color& b) {
  const auto light = [](const Color& color) {
    const auto linear = [](int value) {
      const double part = value / 255.0;
      return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]) + 0.05;
  };
  return std::max(light(a) / light(b), light(b) / light(a));
}

TEST(ColorMap, IsSeenOnTheBackgroundIfDiverging) {
  for (const bool dark : {false, true})
    for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0})
      for (const Color& ground : {palette(dark).backgroundTop, palette(dark).backgroundBottom})
        EXPECT_GE(contrast(colorOf(ColorMap::diverging, at, dark), ground), 3) << dark << at;
}

TEST(LegendColors, RunFromFirstToLastValueAndNoFarther) {
  const LegendColors colors({.title = "h", .unit = {}, .from = 10, .to = 20, .categories = {}},
                            false);
  EXPECT_EQ(colors(10), colorOf(ColorMap::viridis, 0, false));
  EXPECT_EQ(colors(20), colorOf(ColorMap::viridis, 1, false));
  EXPECT_EQ(colors(-1e9), colors(10));
  EXPECT_EQ(colors(1e9), colors(20));
}

// A range chosen by hand need not lie evenly about the middle.
TEST(LegendColors, KeepTheNeutralColorAtTheMiddleOfADivergingMap) {
  const auto at = [](double from, double to, double value) {
    return LegendColors({.title = "d",
                         .unit = {},
                         .map = ColorMap::diverging,
                         .from = from,
                         .to = to,
                         .middle = 1,
                         .categories = {}},
                        false)(value);
  };
  const Color neutral = at(0, 2, 1);
  EXPECT_EQ(at(-5, 1.5, 1), neutral);
  EXPECT_EQ(at(-5, 1.5, -2), at(0, 2, 0.5)) << "half as far as the end";
  EXPECT_EQ(at(1, 3, 1), neutral);
  EXPECT_EQ(at(-1, 1, 1), neutral);
  EXPECT_EQ(at(2, 3, 3), at(0, 2, 2));
  EXPECT_EQ(at(-3, -1, -3), at(0, 2, 0));
}

TEST(LegendColors, FollowTheScaleThatIsChosen) {
  ColorScales scales{.ranges = {{"a", {2, 3}}}, .points = ColorMap::cividis};
  const Legend given{.id = "a", .title = {}, .unit = {}, .categories = {}};
  EXPECT_EQ(LegendColors(scales.ofPoints(given), false)(2), colorOf(ColorMap::cividis, 0, false));
  EXPECT_EQ(LegendColors(scales.ofNodes(given), false)(3), colorOf(ColorMap::viridis, 1, false));
  Legend other = given;
  other.id = "b";
  other.map = ColorMap::diverging;
  EXPECT_EQ(scales.ofPoints(other), other) << "whose sides mean something";
}

TEST(Histogram, CountsEachValueOnce) {
  std::vector<double> values;
  for (int i = 0; i <= 1000; ++i)
    values.push_back(i / 1000.0);
  values.push_back(std::nan(""));
  const Histogram histogram = histogramOf(values, {0, 1});
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0), 1001);
  for (const int count : histogram.counts)
    EXPECT_NEAR(count, 1001.0 / double(histogram.counts.size()), 2); // they are spread evenly
  EXPECT_EQ(histogram.range, (ValueRange{0, 1}));
}

TEST(Histogram, ReachesHalfARangeBeyondTheUsualAtMost) {
  EXPECT_EQ(histogramOf({-0.25, 0.5, 900}, {0, 1}).range, (ValueRange{-0.25, 1.5}));
  EXPECT_EQ(histogramOf({0.5}, {0, 1}).range, (ValueRange{0, 1}));
}

TEST(Histogram, IsEmptyOfNothing) {
  EXPECT_TRUE(histogramOf({}, {0, 1}).counts.empty());
  EXPECT_TRUE(histogramOf({std::nan("")}, {0, 1}).counts.empty());
}

TEST(LegendColors, AreThoseOfTheCategories) {
  const LegendColors colors(
      {.title = "c", .unit = {}, .categories = {{"a", {1, 0, 0}}, {"b", {2, 0, 0}}}}, false);
  EXPECT_EQ(colors(0), (Color{1, 0, 0}));
  EXPECT_EQ(colors(1), (Color{2, 0, 0}));
  EXPECT_EQ(colors(7), (Color{2, 0, 0}));
}

} // namespace
} // namespace espalier
