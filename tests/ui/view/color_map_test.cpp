#include "ui/view/color_map.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

// By the weights of sRGB.
double luminance(const Color& color) {
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

TEST(ColorMap, GetsLighterFromEndToEndIfSequential) {
  for (const ColorMap map : {ColorMap::viridis, ColorMap::cividis})
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

TEST(LegendColors, RunFromFirstToLastValueAndNoFarther) {
  const LegendColors colors({.title = "h", .unit = {}, .from = 10, .to = 20, .categories = {}},
                            false);
  EXPECT_EQ(colors(10), colorOf(ColorMap::viridis, 0, false));
  EXPECT_EQ(colors(20), colorOf(ColorMap::viridis, 1, false));
  EXPECT_EQ(colors(-1e9), colors(10));
  EXPECT_EQ(colors(1e9), colors(20));
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
