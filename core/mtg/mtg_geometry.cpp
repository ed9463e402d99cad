#include "core/mtg/mtg_geometry.h"

#include "core/base/coordinates.h"
#include "core/base/text.h"
#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_values.h"

#include <cmath>
#include <initializer_list>
#include <string_view>

namespace espalier {
namespace {

MtgGeometry::Feature featureNamed(const Mtg& mtg, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    for (std::size_t i = 0; i < mtg.features.size(); ++i)
      if (lowerCase(mtg.features[i].name) == name) return i;
  return std::nullopt;
}

bool hasValue(const MtgVertex& vertex, const MtgGeometry::Feature& feature) {
  return feature && *feature < vertex.values.size() && !isMissingMtgValue(vertex.values[*feature]);
}

} // namespace

MtgGeometry::MtgGeometry(const Mtg& mtg)
    : position{featureNamed(mtg, {"xx", "x"}), featureNamed(mtg, {"yy", "y"}),
               featureNamed(mtg, {"zz", "z"})},
      radius(featureNamed(mtg, {"radius"})), diameter(featureNamed(mtg, {"diameter"})) {}

MtgGeometry::Feature MtgGeometry::radiusFeature(const MtgVertex& vertex) const {
  if (hasValue(vertex, radius)) return radius;
  if (hasValue(vertex, diameter)) return diameter;
  return std::nullopt;
}

std::optional<double> mtgNumber(const MtgVertex& vertex, const MtgGeometry::Feature& feature,
                                const std::string& file) {
  if (!hasValue(vertex, feature)) return std::nullopt;
  const std::string& text = vertex.values[*feature];
  const auto number = numberIn(text);
  if (!number)
    throw ShownError({espalier::Shown::tr("%1 stands for a coordinate or radius of a vertex %2, "
                                          "expected a number"),
                      {inQuotes(text), vertex.symbol},
                      FilePlace{file}});
  if (!std::isfinite(*number)) return std::nullopt;
  if (std::abs(*number) > largestCoordinate)
    throw ShownError({espalier::Shown::tr("vertex %1, %2: its place or radius is beyond 1e12, as "
                                          "of no plant: correct or remove it"),
                      {mtgLabel(vertex), inQuotes(text)},
                      FilePlace{file}});
  return number;
}

std::optional<Eigen::Vector3d> mtgPosition(const MtgVertex& vertex, const MtgGeometry& geometry,
                                           const std::string& file) {
  Eigen::Vector3d position;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = mtgNumber(vertex, geometry.position[axis], file);
    if (!value) return std::nullopt;
    position[static_cast<Eigen::Index>(axis)] = *value;
  }
  return position;
}

} // namespace espalier
