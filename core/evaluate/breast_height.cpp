#include "core/evaluate/breast_height.h"

#include "core/evaluate/axis_traits.h"

#include <cmath>

namespace espalier {
namespace {

struct StemDiameter {
  std::optional<double> value; // [L]
  std::string missing;
};

/// @param role what it is called: "the plant"
StemDiameter diameterAt(const Skeleton& skeleton, const Axis& stem, double z,
                        const std::string& role) {
  if (stem.empty() || skeleton[stem.front()].position.z() > z)
    return {{}, role + " begins above breast height"};
  for (std::size_t i = 1; i < stem.size(); ++i) {
    const Node& below = skeleton[stem[i - 1]];
    const Node& above = skeleton[stem[i]];
    if (above.position.z() < z || above.position.z() <= below.position.z()) continue;
    if (!(below.radius > 0 && above.radius > 0))
      return {{}, role + " has no radius at breast height"};
    const double share = (z - below.position.z()) / (above.position.z() - below.position.z());
    return {2 * std::lerp(below.radius, above.radius, share), {}};
  }
  return {{}, "the stem of " + role + " does not rise to breast height, 1.3 m"};
}

} // namespace

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
    diameters.missing = "the unit of the lengths is not known";
    return diameters;
  }
  const double z = reference[stem.front()].position.z() + height;
  const StemDiameter expected = diameterAt(reference, stem, z, "the reference");
  const StemDiameter found = diameterAt(result, stemOf(result), z, "the plant");
  diameters.reference = expected.value;
  diameters.result = found.value;
  diameters.missing = expected.missing.empty() ? found.missing : expected.missing;
  return diameters;
}

} // namespace espalier
