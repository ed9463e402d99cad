#include "core/clean/value_ranges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

template <class Value, class IsInside>
std::vector<bool> outside(const std::vector<Value>& values, const IsInside& isInside) {
  std::vector<bool> result;
  result.reserve(values.size());
  for (const Value& value : values)
    result.push_back(!isInside(value));
  return result;
}

/// Hue in [0, 2 pi), 0 for grays, and saturation in [0, 1].
std::pair<double, double> hueOf(const Color& color) {
  const double red = color[0];
  const double green = color[1];
  const double blue = color[2];
  const double most = std::max({red, green, blue});
  const double span = most - std::min({red, green, blue});
  if (span == 0) return {0, 0};
  double sixth = most == red     ? (green - blue) / span
                 : most == green ? 2 + (blue - red) / span
                                 : 4 + (red - green) / span;
  if (sixth < 0) sixth += 6;
  return {sixth * std::numbers::pi / 3, span / most};
}

} // namespace

std::vector<bool> outsideIntensities(const std::vector<float>& intensities,
                                     const IntensityRange& range) {
  if (intensities.empty()) return {};
  const auto [low, high] = std::ranges::minmax(intensities);
  const double from = static_cast<double>(low);
  const double span = static_cast<double>(high) - from;
  return outside(intensities, [&](float value) {
    const double share = span > 0 ? (static_cast<double>(value) - from) / span : 0.5;
    return share >= range.least && share <= range.most;
  });
}

std::vector<bool> outsideColors(const std::vector<Color>& colors, const ColorRange& range) {
  return outside(colors, [&](const Color& color) {
    return color[0] >= range.leastRed && color[0] <= range.mostRed &&
           color[1] >= range.leastGreen && color[1] <= range.mostGreen &&
           color[2] >= range.leastBlue && color[2] <= range.mostBlue;
  });
}

std::vector<bool> outsideHues(const std::vector<Color>& colors, const HueRange& range) {
  return outside(colors, [&](const Color& color) {
    const auto [hue, saturation] = hueOf(color);
    const bool isBetween = range.from <= range.to ? hue >= range.from && hue <= range.to
                                                  : hue >= range.from || hue <= range.to;
    return isBetween && saturation >= range.leastSaturation;
  });
}

std::vector<bool> outsideGreenness(const std::vector<Color>& colors, const GreennessRange& range) {
  return outside(colors, [&](const Color& color) {
    const double sum = color[0] + color[1] + color[2];
    const double excess = sum > 0 ? (2.0 * color[1] - color[0] - color[2]) / sum : 0;
    return excess >= range.least && excess <= range.most;
  });
}

} // namespace espalier
