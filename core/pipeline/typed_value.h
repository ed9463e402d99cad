#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// What a number that people type is counted in.
enum class ValueUnit {
  none,
  spacings,
  heights,
  thicknesses,
  scatters,
  millimeters,
  centimeters,
  meters,
  degrees
};

[[nodiscard]] bool isMetric(ValueUnit unit);            // millimeters, centimeters, meters
[[nodiscard]] double metersIn(ValueUnit unit);          // pre: isMetric(unit)
[[nodiscard]] double metersIn(std::string_view symbol); // of "mm", "cm", "m"; else 0

/// The units of which one of the names begins so: "sp" stands for spacings, "s" for these and
/// scatters, all for nothing.
[[nodiscard]] std::vector<ValueUnit> unitsBeginning(std::string_view letters);

/// A number and its unit, as people type them.
struct TypedValue {
  enum class State { complete, begun, wrong };
  State state = State::wrong; // begun: what is typed on may make it complete
  double amount = 0;          // finite if complete; else of no meaning
  ValueUnit unit = ValueUnit::none;
  std::string_view digits;  // the number as it was typed
  std::string_view letters; // what stands behind it, without blanks around
};

/// Reads "12.5", "6 spacings", "6sp", "0.02 heights", "3 thicknesses", "2 scatters", "38mm", "3
/// cm", "30 deg": the form in the window and the command line take the same. Blanks, capital
/// letters and a comma for the point are fine.
/// @return views of `text`
[[nodiscard]] TypedValue typedValue(std::string_view text);

/// A length in mm, cm or m as the number that it is in a unit of so many meters: "38mm" is "0.038"
/// where lengths are in m. Any other text, and each text where `meters` is 0, for a unit that is
/// not known, stays as it is.
[[nodiscard]] std::string inUnitOf(double meters, const std::string& text);

} // namespace espalier
