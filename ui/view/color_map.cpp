#include "ui/view/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

constexpr std::array<Color, 9> viridisStops = {{{68, 1, 84},
                                                {71, 45, 123},
                                                {59, 82, 139},
                                                {44, 114, 142},
                                                {33, 145, 140},
                                                {40, 174, 128},
                                                {94, 201, 98},
                                                {173, 220, 48},
                                                {253, 231, 37}}};

constexpr std::array<Color, 9> cividisStops = {{{0, 32, 76},
                                                {5, 53, 110},
                                                {64, 77, 107},
                                                {96, 99, 110},
                                                {124, 123, 119},
                                                {155, 148, 119},
                                                {188, 174, 110},
                                                {223, 202, 93},
                                                {255, 233, 69}}};

constexpr std::array<Color, 2> grayStops = {{{0, 0, 0}, {255, 255, 255}}};

// The middle steps back toward the background, but thin edges are still seen on it.
constexpr std::array<Color, 3> divergingOnLight = {{{0, 114, 178}, {128, 133, 130}, {213, 94, 0}}};
constexpr std::array<Color, 3> divergingOnDark = {
    {{60, 160, 225}, {124, 130, 127}, {240, 120, 30}}};

template <std::size_t Count> Color between(const std::array<Color, Count>& stops, double fraction) {
  const double at = fraction * static_cast<double>(Count - 1);
  const auto stop = std::min(static_cast<std::size_t>(at), Count - 2);
  const double part = at - static_cast<double>(stop);
  Color color{};
  for (std::size_t c = 0; c < color.size(); ++c)
    color[c] = static_cast<std::uint8_t>(
        std::lround((1 - part) * stops[stop][c] + part * stops[stop + 1][c]));
  return color;
}

/// The values that are numbers: least and greatest; none if there are none.
std::optional<ValueRange> extentOf(const std::vector<double>& values) {
  std::optional<ValueRange> extent;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!extent) extent = {value, value};
    extent->from = std::min(extent->from, value);
    extent->to = std::max(extent->to, value);
  }
  return extent;
}

Legend withScale(Legend legend, const std::map<QString, ValueRange>& ranges, ColorMap map) {
  if (const auto range = ranges.find(legend.id);
      range != ranges.end() && legend.categories.empty()) {
    legend.from = range->second.from;
    legend.to = range->second.to;
  }
  if (legend.map == ColorMap::viridis) legend.map = map;
  return legend;
}

} // namespace

Color colorOf(ColorMap map, double fraction, bool dark) {
  const auto part = [&](double from, double to) { return from + (to - from) * fraction; };
  switch (map) {
  case ColorMap::cividis:
    return between(cividisStops, dark ? part(0.2, 1) : part(0.05, 0.85));
  case ColorMap::gray:
    return between(grayStops, dark ? part(0.25, 0.95) : part(0.1, 0.78));
  case ColorMap::diverging:
    return between(dark ? divergingOnDark : divergingOnLight, fraction);
  default:
    return between(viridisStops, dark ? part(0.14, 1) : part(0.1, 0.88));
  }
}

Histogram histogramOf(const std::vector<double>& values, const ValueRange& usual) {
  const std::optional<ValueRange> extent = extentOf(values);
  if (!extent || !(usual.from < usual.to)) return {};
  constexpr std::size_t bins = 48;
  const double room = (usual.to - usual.from) / 2;
  Histogram histogram{.range = {std::min(usual.from, std::max(extent->from, usual.from - room)),
                                std::max(usual.to, std::min(extent->to, usual.to + room))},
                      .counts = std::vector<int>(bins)};
  const ValueRange& range = histogram.range;
  const double perBin = static_cast<double>(bins) / (range.to - range.from);
  for (const double value : values)
    if (value >= range.from && value <= range.to)
      ++histogram
            .counts[std::min(static_cast<std::size_t>((value - range.from) * perBin), bins - 1)];
  return histogram;
}

double Legend::fraction(double value) const {
  const double held = std::clamp(value, from, to);
  if (map != ColorMap::diverging) return (held - from) / (to - from);
  // A range that ends before the middle, as one chosen by hand may, has one half of the map.
  if (held >= middle) return to > middle ? 0.5 + 0.5 * (held - middle) / (to - middle) : 0.5;
  return 0.5 - 0.5 * (middle - held) / (middle - from);
}

ValueRange Legend::axis() const {
  if (histogram.counts.empty()) return {from, to};
  return {std::min(from, histogram.range.from), std::max(to, histogram.range.to)};
}

Legend ColorScales::ofPoints(const Legend& given) const {
  return withScale(given, ranges, points);
}

Legend ColorScales::ofNodes(const Legend& given) const {
  return withScale(given, ranges, nodes);
}

LegendColors::LegendColors(const Legend& legend, bool dark) : legend_(legend) {
  for (const Legend::Category& category : legend.categories)
    colors_.push_back(category.color);
  if (!colors_.empty()) return;
  constexpr int count = 256;
  for (int i = 0; i < count; ++i)
    colors_.push_back(colorOf(legend.map, i / (count - 1.0), dark));
}

Color LegendColors::operator()(double value) const {
  const auto last = static_cast<double>(colors_.size() - 1);
  const double at =
      legend_.categories.empty() ? last * legend_.fraction(value) : std::clamp(value, 0.0, last);
  return colors_[static_cast<std::size_t>(std::lround(at))];
}

} // namespace espalier
