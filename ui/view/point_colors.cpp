#include "ui/view/point_colors.h"

#include <algorithm>
#include <cmath>

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

using Table = std::array<Color, 256>;

Table viridisTable(bool dark) {
  Table table;
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = viridis(static_cast<double>(i) / 255, dark);
  return table;
}

Color mapped(const Table& table, double value, const ColorScale& scale) {
  const double fraction = (value - scale.from) / (scale.to - scale.from);
  const double step = 255 * std::clamp(fraction, 0.0, 1.0);
  return table[static_cast<std::size_t>(std::lround(step))];
}

/// Between which intensities all but the highest and lowest 2 % are.
ColorScale intensityScale(std::vector<float> values) {
  const auto at = [&](double part) {
    const auto place = values.begin() + std::lround(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
  };
  const double low = at(0.02);
  const double high = at(0.98);
  if (low < high) return {ColorScale::Quantity::intensity, low, high};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {ColorScale::Quantity::intensity, *least, *most};
}

} // namespace

Color viridis(double fraction, bool dark) {
  const double from = dark ? 0.14 : 0.1;
  const double to = dark ? 1 : 0.88;
  const double at = (from + (to - from) * fraction) * 8;
  const auto stop = std::min(static_cast<std::size_t>(at), viridisStops.size() - 2);
  const double part = at - static_cast<double>(stop);
  Color color;
  for (std::size_t c = 0; c < color.size(); ++c) {
    const double value = (1 - part) * viridisStops[stop][c] + part * viridisStops[stop + 1][c];
    color[c] = static_cast<std::uint8_t>(std::lround(value));
  }
  return color;
}

std::optional<ColorScale> colorScale(const PointCloud& cloud, PointColor by) {
  if (cloud.isEmpty()) return std::nullopt;
  std::optional<ColorScale> scale;
  if (by == PointColor::height) {
    const Eigen::AlignedBox3d box = cloud.bounds();
    scale = {ColorScale::Quantity::height, box.min().z(), box.max().z()};
  } else if (by == PointColor::intensity && !cloud.intensities().empty()) {
    scale = intensityScale(cloud.intensities());
  }
  if (scale && !(scale->from < scale->to)) scale.reset();
  return scale;
}

std::vector<Color> pointColors(const PointCloud& cloud, PointColor by, bool dark,
                               const Color& plain) {
  if (by == PointColor::rgb && !cloud.colors().empty()) return cloud.colors();
  std::vector<Color> colors(static_cast<std::size_t>(cloud.size()), plain);
  const std::optional<ColorScale> scale = colorScale(cloud, by);
  if (!scale) return colors;
  const Table table = viridisTable(dark);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double value =
        scale->quantity == ColorScale::Quantity::intensity
            ? static_cast<double>(cloud.intensities()[i])
            : cloud.positions()(2, static_cast<Eigen::Index>(i)) + cloud.origin().z();
    colors[i] = mapped(table, value, *scale);
  }
  return colors;
}

} // namespace espalier
