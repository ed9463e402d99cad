#pragma once

#include <limits>
#include <string>

namespace espalier {

/// What default rules derive lengths from.
struct PlantScale {
  double spacing = 0; // mean distance between neighboring points [L]
  double height = 0;  // extent along the up axis [L]
  /// How thick the thin wood is, as its points show (core/cloud/thin_wood.h) [L]; if that is not
  /// known, as thick as need be.
  double thickness = std::numeric_limits<double>::infinity();
  /// Standard deviation of the points normal to the surface of the wood, as they show it (likewise)
  /// [L].
  double scatter = 0;
};

/// [spacings] Where the thin wood is as thick as this, thicker wood needs no longer lengths.
inline constexpr double enoughThickness = 2.5;

/// How a value follows from the plant: the sum of its parts.
struct Rule {
  double fixed = 0;       // for counts and ratios
  double spacings = 0;    // in point spacings
  double heights = 0;     // in plant heights
  double thicknesses = 0; // of the thin wood, each at most enoughThickness
  double scatters = 0;    // of the points

  [[nodiscard]] double value(const PlantScale& scale) const;
  [[nodiscard]] bool isFixed() const {
    return spacings == 0 && heights == 0 && thicknesses == 0 && scatters == 0;
  }
  [[nodiscard]] std::string text() const; // "7.5 point spacings"
  bool operator==(const Rule&) const = default;
};

// Where points scatter wide, more than enoughThickness does no good either: on 28 simulated plants
// that scatter by 0.9 to 3.9 spacings, the default lengths for wood 2.5, 4, 6 and 9 spacings thick
// give F within 2.5 spacings .864, .853, .822 and .750, and T .911, .862, .883 and .837.

[[nodiscard]] constexpr Rule fixedAt(double value) {
  return {.fixed = value};
}
[[nodiscard]] constexpr Rule spacings(double count) {
  return {.spacings = count};
}
[[nodiscard]] constexpr Rule heights(double count) {
  return {.heights = count};
}

[[nodiscard]] constexpr Rule thicknesses(double count) {
  return {.thicknesses = count};
}
[[nodiscard]] constexpr Rule scatters(double count) {
  return {.scatters = count};
}
[[nodiscard]] constexpr Rule operator+(const Rule& a, const Rule& b) {
  return {.fixed = a.fixed + b.fixed,
          .spacings = a.spacings + b.spacings,
          .heights = a.heights + b.heights,
          .thicknesses = a.thicknesses + b.thicknesses,
          .scatters = a.scatters + b.scatters};
}

/// A length in an options struct [L], whose default may be a rule. The option table of a method
/// gives it the value for the plant at hand; until then a length by a rule is 0.
class Length {
public:
  constexpr Length(double value) : rule_(fixedAt(value)) {}
  constexpr Length(const Rule& rule) : rule_(rule) {}
  constexpr operator double() const { return rule_.fixed; }
  [[nodiscard]] constexpr const Rule& rule() const { return rule_; }

private:
  Rule rule_;
};

} // namespace espalier
