#include "core/pipeline/option_table.h"

#include "core/pipeline/typed_value.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace espalier {
namespace {

const std::array<std::string, 2> flagWords = {"no", "yes"};

} // namespace

std::optional<Rule> ruleIn(std::string_view text) {
  const TypedValue typed = typedValue(text);
  if (typed.state != TypedValue::State::complete) return std::nullopt;
  if (typed.unit == ValueUnit::none) return fixedAt(typed.amount);
  if (typed.unit == ValueUnit::spacings) return spacings(typed.amount);
  if (typed.unit == ValueUnit::heights) return heights(typed.amount);
  if (typed.unit == ValueUnit::thicknesses) return thicknesses(typed.amount);
  if (typed.unit == ValueUnit::scatters) return scatters(typed.amount);
  return std::nullopt;
}

std::pair<double, double> Option::range(const PlantScale& scale) const {
  const double unit = kind == OptionKind::length ? scale.spacing : 1;
  return {minimum * unit, maximum * unit};
}

std::string Option::ruleText() const {
  return takesWords() ? wordFor(rule.fixed) : rule.text();
}

const std::string& Option::wordFor(double value) const {
  assert(takesWords() && value >= 0 && value <= maximum);
  const auto place = static_cast<std::size_t>(value);
  return kind == OptionKind::flag ? flagWords[place] : choices[place].name;
}

std::optional<double> Option::valueOf(std::string_view word) const {
  if (kind == OptionKind::flag) {
    if (word == "yes" || word == "true" || word == "on") return 1;
    if (word == "no" || word == "false" || word == "off") return 0;
    return std::nullopt;
  }
  const auto found = std::ranges::find(choices, word, &Choice::name);
  if (found == choices.end()) return std::nullopt;
  return static_cast<double>(found - choices.begin());
}

std::string Option::words() const {
  if (kind == OptionKind::flag) return flagWords[1] + ", " + flagWords[0];
  std::string all;
  for (const Choice& choice : choices)
    all += (all.empty() ? "" : ", ") + choice.name;
  return all;
}

std::string nameOf(OptionKind kind) {
  switch (kind) {
  case OptionKind::length:
    return "length";
  case OptionKind::ratio:
  case OptionKind::curve: // where it is no form, its exponent
    return "ratio";
  case OptionKind::count:
    return "count";
  case OptionKind::angle:
    return "angle";
  case OptionKind::choice:
    return "choice";
  case OptionKind::flag:
    return "flag";
  }
  return {};
}

} // namespace espalier
