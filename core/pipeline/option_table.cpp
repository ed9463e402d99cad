#include "core/pipeline/option_table.h"

#include <sstream>

namespace espalier {

std::string Rule::text() const {
  std::ostringstream text;
  const auto append = [&](double amount, const char* unit) {
    if (amount == 0) return;
    if (text.tellp() > 0) text << " + ";
    text << amount << unit;
  };
  append(spacings, spacings == 1 ? " point spacing" : " point spacings");
  append(heights, heights == 1 ? " plant height" : " plant heights");
  append(fixed, "");
  return text.tellp() > 0 ? text.str() : "0";
}

std::pair<double, double> Option::range(const PlantScale& scale) const {
  const double unit = kind == OptionKind::length ? scale.spacing : 1;
  return {minimum * unit, maximum * unit};
}

std::string nameOf(OptionKind kind) {
  switch (kind) {
  case OptionKind::length:
    return "length";
  case OptionKind::ratio:
    return "ratio";
  case OptionKind::count:
    return "count";
  case OptionKind::angle:
    return "angle";
  }
  return {};
}

} // namespace espalier
