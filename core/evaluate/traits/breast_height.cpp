#include "core/evaluate/traits/breast_height.h"

#include "core/base/shown.h"
#include "core/evaluate/traits/axis_traits.h"
#include "core/evaluate/traits/stem_diameter.h"

namespace espalier {

double breastHeightIn(std::string_view unit) {
  return unit == "mm" ? 1300 : unit == "cm" ? 130 : unit == "m" ? 1.3 : 0;
}

std::optional<double> StemDiameters::error() const {
  if (!result || !reference) return std::nullopt;
  return *result - *reference;
}

std::optional<double> StemDiameters::relativeError() const {
  if (!result || !reference) return std::nullopt;
  return *result / *reference - 1;
}

StemDiameters stemDiameters(const Skeleton& result, const Skeleton& reference, double height) {
  StemDiameters diameters{.height = height};
  const Axis stem = stemOf(reference);
  if (!(height > 0) || stem.empty()) {
    diameters.missing = Shown::tr("the unit of the lengths is not known");
    return diameters;
  }
  const double z = reference[stem.front()].position.z() + height;
  const StemDiameter expected = stemDiameterAt(reference, z, StemOf::reference);
  const StemDiameter found = stemDiameterAt(result, z, StemOf::plant);
  diameters.reference = expected.value;
  diameters.result = found.value;
  diameters.missing = expected.missing.empty() ? found.missing : expected.missing;
  return diameters;
}

} // namespace espalier
