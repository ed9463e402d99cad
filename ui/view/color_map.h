#pragma once

#include "core/cloud/point_cloud.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace espalier {

/// Maps that the color-blind can read: viridis (S. van der Walt, N. Smith, 2015), cividis
/// (J. Nuñez, C. Anderton, R. Renslow, PLOS ONE 13(7), 2018), and for values with a sign blue over
/// a neutral middle to vermillion.
enum class ColorMap : std::uint8_t { viridis, cividis, diverging };

/// A color of a map, in the part of it that stands out from background and skeleton.
[[nodiscard]] Color colorOf(ColorMap map, double fraction, bool dark); // fraction in [0, 1]

/// What the colors of points or nodes stand for, and so what a color bar tells.
struct Legend {
  struct Category {
    QString name;
    Color color{};
    bool operator==(const Category&) const = default;
  };

  QString title;
  QString unit; // empty: none
  ColorMap map = ColorMap::viridis;
  double from = 0; // value of the first color
  double to = 1;   // value of the last, > from; values beyond take the first or last color
  std::vector<Category> categories; // if any, values are indices of these, and there is no scale

  bool operator==(const Legend&) const = default;
};

/// The colors of a legend, ready for many values.
class LegendColors {
public:
  LegendColors(const Legend& legend, bool dark);

  /// pre: `value` is a number. Of categories, the nearest index.
  [[nodiscard]] Color operator()(double value) const;

private:
  std::vector<Color> colors_; // evenly from first to last, or of the categories
  double from_;
  double step_;
};

} // namespace espalier
