#pragma once

#include <string>

namespace espalier {

/// What default rules derive lengths from.
struct PlantScale {
  double spacing = 0; // mean distance between neighboring points [L]
  double height = 0;  // extent along the up axis [L]
};

/// How a value follows from the plant: the sum of its parts.
struct Rule {
  double fixed = 0;    // for counts and ratios
  double spacings = 0; // in point spacings
  double heights = 0;  // in plant heights

  [[nodiscard]] double value(const PlantScale& scale) const {
    return fixed + spacings * scale.spacing + heights * scale.height;
  }
  [[nodiscard]] bool isFixed() const { return spacings == 0 && heights == 0; }
  [[nodiscard]] std::string text() const; // "7.5 point spacings"
  bool operator==(const Rule&) const = default;
};

[[nodiscard]] constexpr Rule fixedAt(double value) {
  return {.fixed = value};
}
[[nodiscard]] constexpr Rule spacings(double count) {
  return {.spacings = count};
}
[[nodiscard]] constexpr Rule heights(double count) {
  return {.heights = count};
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
