#include "app/window/frame/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& color) {
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

/// Contrast of two colors as WCAG 2.1 defines it.
double contrast(const QColor& a, const QColor& b) {
  const double first = luminance(a) + 0.05;
  const double second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

TEST(Theme, IsFoundAgainByItsName) {
  for (const Theme theme : {Theme::system, Theme::light, Theme::dark})
    EXPECT_EQ(themeNamed(nameOf(theme)), theme);
  EXPECT_EQ(themeNamed("pink"), Theme::system);
}

TEST(Theme, KeepsTextReadable) {
  for (const bool dark : {false, true}) {
    const ThemeColors colors = themeColors(dark);
    for (const QColor& ground : {colors.panel, colors.field, colors.button, colors.hover}) {
      EXPECT_GE(contrast(colors.text, ground), 4.5) << dark;
      EXPECT_GE(contrast(colors.quiet, ground), 4.5) << dark << ground.name().toStdString();
    }
    EXPECT_GE(contrast(colors.onPrimary, colors.primary), 4.5) << dark;
    EXPECT_GE(contrast(colors.onError, colors.error), 4.5) << dark;
    EXPECT_GE(contrast(colors.accent, colors.panel), 3) << dark;
  }
}

} // namespace
} // namespace espalier
