#include "core/mtg/typed_values.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/mtg/mtg_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace espalier {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isWhole(std::string_view text) {
  constexpr std::size_t mostDigits = 18; // fits every reader's integer
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && text.size() <= mostDigits && std::ranges::all_of(text, isDigit);
}

struct DateForm {
  std::string_view type;
  std::string_view pattern; // d, m, y, h and n stand for digits of day, month, year, hour, minute
  const char* example;
};

constexpr auto dateForms = std::to_array<DateForm>({
    {"DD/MM", "dd/mm", "31/12"},
    {"MM/YY", "mm/yy", "12/98"},
    {"DD/MM/YY", "dd/mm/yy", "31/12/98"},
    {"DD/MM/YYYY", "dd/mm/yyyy", "31/12/1998"},
    {"DD/MM-TIME", "dd/mm-hh:nn", "31/12-14:30"},
    {"DD/MM/YY-TIME", "dd/mm/yy-hh:nn", "31/12/98-14:30"},
});

bool isDate(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return false;
  int day = 1;
  int month = 1;
  int hour = 0;
  int minute = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (!isLetter(pattern[i])) {
      if (text[i] != pattern[i]) return false;
      continue;
    }
    if (!isDigit(text[i])) return false;
    int ignored = 0;
    int& part = pattern[i] == 'd'   ? day
                : pattern[i] == 'm' ? month
                : pattern[i] == 'h' ? hour
                : pattern[i] == 'n' ? minute
                                    : ignored;
    const bool isFirst = i == 0 || pattern[i - 1] != pattern[i];
    part = (isFirst ? 0 : 10 * part) + (text[i] - '0');
  }
  constexpr std::array<int, 12> days = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return month >= 1 && month <= 12 && day >= 1 && day <= days[std::size_t(month) - 1] &&
         hour <= 23 && minute <= 59;
}

[[noreturn]] void refuse(const MtgFeature& feature, const std::string& text, const char* sentence,
                         const std::string& example) {
  throw ShownError({sentence, {feature.name, feature.type, inQuotes(text), example}});
}

} // namespace

std::string typedValue(const MtgFeature& feature, const std::string& text) {
  std::string value(trimmed(text));
  if (value.empty()) return value;
  if (feature.type == "REAL") {
    const auto number = numberIn(value);
    if (!number || !std::isfinite(*number))
      refuse(feature, value,
             espalier::Shown::tr("%1 is of type %2: %3 is not a number, such as %4"), "12.5");
  }
  if (feature.type == "INT" && !isWhole(value))
    refuse(feature, value,
           espalier::Shown::tr("%1 is of type %2: %3 is not a whole number, such as %4"), "12");
  const auto form = std::ranges::find(dateForms, feature.type, &DateForm::type);
  if (form != dateForms.end() && !isDate(value, form->pattern))
    refuse(feature, value, espalier::Shown::tr("%1 is of type %2: %3 is not a date, such as %4"),
           form->example);
  if (!survivesMtg(value))
    throw ShownError(
        {espalier::Shown::tr(
             "%1 cannot stand in an MTG: take out tabs, line ends and comment signs (# and ;)"),
         {inQuotes(value)}});
  return value;
}

std::span<const std::string_view> featureTypes() {
  static constexpr auto types =
      std::to_array<std::string_view>({"REAL", "INT", "ALPHA", "STRING", "DD/MM/YY", "DD/MM/YYYY",
                                       "DD/MM", "MM/YY", "DD/MM-TIME", "DD/MM/YY-TIME"});
  return types;
}

std::string exampleOf(std::string_view featureType) {
  if (featureType == "REAL") return "12.5";
  if (featureType == "INT") return "12";
  const auto form = std::ranges::find(dateForms, featureType, &DateForm::type);
  return form == dateForms.end() ? "oak" : form->example;
}

std::string typedFeatureName(const std::string& text) {
  std::string name(trimmed(text));
  constexpr std::size_t longest = 64;
  const auto isPart = [](char c) { return isLetter(c) || isDigit(c) || c == '_'; };
  if (name.empty() || name.size() > longest || !isLetter(name.front()) ||
      !std::ranges::all_of(name, isPart))
    throw ShownError(
        {espalier::Shown::tr(
             "%1 is no name of a feature: type letters, digits and _, such as Length or leaf_area"),
         {inQuotes(name)}});
  std::string small = name;
  std::ranges::transform(small, small.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c + ('a' - 'A')) : c; });
  constexpr auto taken = std::to_array<std::string_view>(
      {"x", "y", "z", "xx", "yy", "zz", "radius", "diameter", "alias"});
  if (std::ranges::find(taken, small) != taken.end())
    throw ShownError(
        {espalier::Shown::tr("%1 stands for the position, radius or alias, which have fields of "
                             "their own: choose another name"),
         {name}});
  return name;
}

std::string typedAlias(const std::string& text) {
  std::string alias(trimmed(text));
  const auto isPart = [](char c) {
    return isLetter(c) || isDigit(c) || static_cast<unsigned char>(c) >= 0x80; // of UTF-8
  };
  const bool isWord = alias.empty() || isPart(alias.front());
  if (!isWord || !std::ranges::all_of(
                     alias, [&](char c) { return isPart(c) || c == '_' || c == '-' || c == '.'; }))
    throw ShownError(
        {espalier::Shown::tr(
             "%1 is no alias: type letters, digits, and _ - . between them, or nothing"),
         {inQuotes(alias)}});
  return alias;
}

std::string typedSymbol(const std::string& text) {
  std::string symbol(trimmed(text));
  constexpr std::size_t longest = 32;
  if (symbol.empty() || symbol.size() > longest || !std::ranges::all_of(symbol, isLetter))
    throw ShownError(
        {espalier::Shown::tr("%1 is no symbol of a class: type letters alone, such as S or GU"),
         {inQuotes(symbol)}});
  return symbol;
}

} // namespace espalier
