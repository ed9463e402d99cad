#include "ui/view/color_map.h"

#include "ui/view/point_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {
namespace {

constexpr std::array<Color, 9> cividisStops = {{{0, 32, 76},
                                                {5, 53, 110},
                                                {64, 77, 107},
                                                {96, 99, 110},
                                                {124, 123, 119},
                                                {155, 148, 119},
                                                {188, 174, 110},
                                                {223, 202, 93},
                                                {255, 233, 69}}};

// The middle steps back toward the background.
constexpr std::array<Color, 3> divergingOnLight = {{{0, 114, 178}, {190, 194, 192}, {213, 94, 0}}};
constexpr std::array<Color, 3> divergingOnDark = {{{60, 160, 225}, {92, 97, 95}, {240, 120, 30}}};

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

} // namespace

Color colorOf(ColorMap map, double fraction, bool dark) {
  switch (map) {
  case ColorMap::cividis: {
    // As viridis(): without the darkest, on light without the brightest.
    const double from = dark ? 0.2 : 0.05;
    const double to = dark ? 1 : 0.85;
    return between(cividisStops, from + (to - from) * fraction);
  }
  case ColorMap::diverging:
    return between(dark ? divergingOnDark : divergingOnLight, fraction);
  default:
    return viridis(fraction, dark);
  }
}

LegendColors::LegendColors(const Legend& legend, bool dark) : from_(legend.from) {
  if (!legend.categories.empty()) {
    for (const Legend::Category& category : legend.categories)
      colors_.push_back(category.color);
    from_ = 0;
    step_ = 1;
    return;
  }
  constexpr int count = 256;
  for (int i = 0; i < count; ++i)
    colors_.push_back(colorOf(legend.map, i / (count - 1.0), dark));
  step_ = (legend.to - legend.from) / (count - 1);
}

Color LegendColors::operator()(double value) const {
  const double last = static_cast<double>(colors_.size() - 1);
  const double at = step_ > 0 ? std::clamp((value - from_) / step_, 0.0, last) : 0;
  return colors_[static_cast<std::size_t>(std::lround(at))];
}

} // namespace espalier
