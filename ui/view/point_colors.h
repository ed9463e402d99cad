#pragma once

#include "core/cloud/point_cloud.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

enum class PointColor { uniform, height, intensity, rgb };

/// What the colors of a color bar stand for.
struct ColorScale {
  enum class Quantity { height, intensity };

  Quantity quantity;
  double from; // value of the first color
  double to;   // value of the last, > from
};

/// A color of the map viridis (S. van der Walt, N. Smith, 2015), in the part of it that stands out
/// from background and skeleton: without its darkest colors, and on light without its brightest.
[[nodiscard]] Color viridis(double fraction, bool dark); // fraction in [0, 1]

/// The scale by which a cloud is colored; none if not by value, or if all values are equal.
/// Intensities are cut at their 2nd and 98th percentile: scanners give some very bright ones.
[[nodiscard]] std::optional<ColorScale> colorScale(const PointCloud& cloud, PointColor by);

/// The color of each point; `plain` for all if the cloud has not what it is to be colored by.
[[nodiscard]] std::vector<Color> pointColors(const PointCloud& cloud, PointColor by, bool dark,
                                             const Color& plain);

} // namespace espalier
