#pragma once

#include "core/cloud/point_cloud.h"

#include <QString>

#include <cstdint>
#include <map>
#include <vector>

namespace espalier {

/// Maps that the color-blind can read: viridis (S. van der Walt, N. Smith, 2015), cividis
/// (J. Nuñez, C. Anderton, R. Renslow, PLOS ONE 13(7), 2018), gray, and for values with a sign blue
/// over a neutral middle to vermillion.
enum class ColorMap : std::uint8_t { viridis, cividis, gray, diverging };

/// A color of a map, in the part of it that stands out from background and skeleton: without its
/// darkest colors, and on light without its brightest.
[[nodiscard]] Color colorOf(ColorMap map, double fraction, bool dark); // fraction in [0, 1]

struct ValueRange {
  double from = 0;
  double to = 1; // > from
  bool operator==(const ValueRange&) const = default;
};

/// How often values are, in bins of one width.
struct Histogram {
  ValueRange range;
  std::vector<int> counts; // none: not known
  bool operator==(const Histogram&) const = default;
};

/// The histogram of what a color bar shows: the usual range, and as much of the values beyond it as
/// leaves room to widen it by half; few stray values do not squeeze the others. O(values).
/// @param values those that are no numbers do not count
[[nodiscard]] Histogram histogramOf(const std::vector<double>& values, const ValueRange& usual);

/// What the colors of points or nodes stand for, and so what a color bar shows.
struct Legend {
  struct Category {
    QString name;
    Color color{};
    bool operator==(const Category&) const = default;
  };

  QString id = {}; // of the value, never translated: a range chosen by hand is kept under it
  QString title;
  QString unit; // empty: none
  ColorMap map = ColorMap::viridis;
  double from = 0;   // value of the first color
  double to = 1;     // value of the last, > from; values beyond take the first or last color
  double middle = 0; // value of the neutral color of a diverging map
  Histogram histogram = {};
  std::vector<Category> categories; // if any, values are indices of these, and there is no scale

  /// Where in the map the color of a value is, in [0, 1]. Either side of the middle has its half.
  [[nodiscard]] double fraction(double value) const;
  /// What a bar of this legend runs over: the range, and that of the histogram.
  [[nodiscard]] ValueRange axis() const;

  bool operator==(const Legend&) const = default;
};

/// What a user has chosen of the scales of all values.
struct ColorScales {
  std::map<QString, ValueRange> ranges; // by the id of the legend; others: as given
  ColorMap points = ColorMap::viridis;  // in place of viridis, of no other
  ColorMap nodes = ColorMap::viridis;

  [[nodiscard]] Legend ofPoints(const Legend& given) const;
  [[nodiscard]] Legend ofNodes(const Legend& given) const;
  bool operator==(const ColorScales&) const = default;
};

/// The colors of a legend, ready for many values.
class LegendColors {
public:
  LegendColors(const Legend& legend, bool dark);

  /// pre: `value` is a number. Of categories, the nearest index.
  [[nodiscard]] Color operator()(double value) const;

private:
  Legend legend_;
  std::vector<Color> colors_; // evenly through the map, or of the categories
};

} // namespace espalier
