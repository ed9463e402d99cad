#include "core/pipeline/typed_value.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

namespace espalier {
namespace {

struct Name {
  std::string_view name;
  ValueUnit unit;
};

constexpr auto names = std::to_array<Name>({
    {"sp", ValueUnit::spacings},
    {"spacing", ValueUnit::spacings},
    {"spacings", ValueUnit::spacings},
    {"point spacing", ValueUnit::spacings},
    {"point spacings", ValueUnit::spacings},
    {"h", ValueUnit::heights},
    {"height", ValueUnit::heights},
    {"heights", ValueUnit::heights},
    {"plant height", ValueUnit::heights},
    {"plant heights", ValueUnit::heights},
    {"th", ValueUnit::thicknesses},
    {"thickness", ValueUnit::thicknesses},
    {"thicknesses", ValueUnit::thicknesses},
    {"thickness of thin wood", ValueUnit::thicknesses},
    {"thicknesses of thin wood", ValueUnit::thicknesses},
    {"sc", ValueUnit::scatters},
    {"scatter", ValueUnit::scatters},
    {"scatters", ValueUnit::scatters},
    {"scatter of points", ValueUnit::scatters},
    {"scatters of points", ValueUnit::scatters},
    {"mm", ValueUnit::millimeters},
    {"cm", ValueUnit::centimeters},
    {"m", ValueUnit::meters},
    {"deg", ValueUnit::degrees},
    {"degree", ValueUnit::degrees},
    {"degrees", ValueUnit::degrees},
    {"\u00b0", ValueUnit::degrees},
});

bool isIn(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

/// How much of the front of `text` may be a number, or begin one.
std::size_t lengthOfDigits(std::string_view text) {
  constexpr std::string_view digits = "0123456789";
  std::size_t at = 0;
  const auto pass = [&](std::string_view set, bool once) {
    while (at < text.size() && isIn(text[at], set)) {
      ++at;
      if (once) return;
    }
  };
  pass("+-", true);
  pass(digits, false);
  pass(".,", true);
  pass(digits, false);
  if (at < text.size() && isIn(text[at], "eE")) {
    ++at;
    pass("+-", true);
    pass(digits, false);
  }
  return at;
}

} // namespace

bool isMetric(ValueUnit unit) {
  return unit == ValueUnit::millimeters || unit == ValueUnit::centimeters ||
         unit == ValueUnit::meters;
}

double metersIn(ValueUnit unit) {
  assert(isMetric(unit));
  if (unit == ValueUnit::millimeters) return 1e-3;
  return unit == ValueUnit::centimeters ? 1e-2 : 1;
}

double metersIn(std::string_view symbol) {
  return symbol == "mm" ? 1e-3 : symbol == "cm" ? 1e-2 : symbol == "m" ? 1 : 0;
}

std::vector<ValueUnit> unitsBeginning(std::string_view letters) {
  const std::string small = lowerCase(letters);
  std::vector<ValueUnit> units;
  if (small.empty()) units.push_back(ValueUnit::none);
  for (const Name& name : names)
    if (name.name.starts_with(small) && std::ranges::count(units, name.unit) == 0)
      units.push_back(name.unit);
  return units;
}

TypedValue typedValue(std::string_view text) {
  text = trimmed(text);
  TypedValue typed;
  typed.digits = text.substr(0, lengthOfDigits(text));
  typed.letters = trimmed(text.substr(typed.digits.size()));
  std::string number(typed.digits);
  std::ranges::replace(number, ',', '.');
  const auto amount = numberIn(number);
  const std::string small = lowerCase(typed.letters);
  const auto* named = std::ranges::find(names, small, &Name::name);
  const bool isNamed = small.empty() || named != names.end();
  if (amount && !std::isfinite(*amount)) return typed;
  if (isNamed && named != names.end()) typed.unit = named->unit;
  if (amount) typed.amount = *amount;
  if (amount && isNamed)
    typed.state = TypedValue::State::complete;
  else if (!unitsBeginning(typed.letters).empty())
    typed.state = TypedValue::State::begun;
  return typed;
}

std::string inUnitOf(double meters, const std::string& text) {
  const TypedValue typed = typedValue(text);
  const bool isConverted =
      meters > 0 && typed.state == TypedValue::State::complete && isMetric(typed.unit);
  return isConverted ? plainDecimal(typed.amount * metersIn(typed.unit) / meters) : text;
}

} // namespace espalier
