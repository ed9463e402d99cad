#include "core/base/rule.h"

#include <algorithm>
#include <sstream>

namespace espalier {

double Rule::value(const PlantScale& scale) const {
  return fixed + spacings * scale.spacing + heights * scale.height +
         thicknesses * std::min(scale.thickness, enoughThickness * scale.spacing) +
         scatters * scale.scatter;
}

std::string Rule::text() const {
  std::ostringstream text;
  const auto append = [&](double amount, const char* unit) {
    if (amount == 0) return;
    if (text.tellp() > 0) text << " + ";
    text << amount << unit;
  };
  append(spacings, spacings == 1 ? " point spacing" : " point spacings");
  append(heights, heights == 1 ? " plant height" : " plant heights");
  append(thicknesses, thicknesses == 1 ? " thickness of thin wood" : " thicknesses of thin wood");
  append(scatters, scatters == 1 ? " scatter of points" : " scatters of points");
  append(fixed, "");
  return text.tellp() > 0 ? text.str() : "0";
}

} // namespace espalier
