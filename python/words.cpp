#include "python/words.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/pipeline/typed_value.h"

#include <array>
#include <initializer_list>
#include <utility>

namespace espalier::python {
namespace {

template <class Value>
Value valueOf(std::string_view word, const char* name,
              std::initializer_list<std::pair<const char*, Value>> all) {
  std::string words;
  for (const auto& [each, value] : all) {
    if (each == word) return value;
    words += (words.empty() ? "" : ", ") + std::string(each);
  }
  throw Error(std::string(name) + " is " + inQuotes(word) + ": choose one of " + words);
}

} // namespace

UpAxis upAxisIn(std::string_view word) {
  return valueOf<UpAxis>(word, "up", {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}});
}

std::string nameOf(UpAxis up) {
  return {"xyz"[static_cast<std::size_t>(up)]};
}

MtgStyle mtgStyleIn(std::string_view word) {
  return valueOf<MtgStyle>(
      word, "scales",
      {{"plant-node", MtgStyle::plantNode}, {"plant-axis-node", MtgStyle::plantAxisNode}});
}

Architecture architectureIn(std::string_view word) {
  return valueOf<Architecture>(word, "architecture",
                               {{"broadleaf", Architecture::broadleaf},
                                {"conifer", Architecture::conifer},
                                {"shrub", Architecture::shrub},
                                {"herb", Architecture::herb}});
}

double metersIn(std::string_view unit) {
  return espalier::metersIn(valueOf<ValueUnit>(
      unit, "unit",
      {{"mm", ValueUnit::millimeters}, {"cm", ValueUnit::centimeters}, {"m", ValueUnit::meters}}));
}

} // namespace espalier::python
