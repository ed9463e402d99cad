#pragma once

#include "core/mtg/mtg.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>

namespace espalier {

/// Which features of an MTG hold positions and radii: XX YY ZZ or X Y Z, radius, Diameter; the case
/// of names does not matter.
struct MtgGeometry {
  using Feature = std::optional<std::size_t>; // place in Mtg::features

  std::array<Feature, 3> position;
  Feature radius;
  Feature diameter;

  explicit MtgGeometry(const Mtg& mtg);

  /// The feature whose value is the radius of this vertex: radius, else Diameter, of which it is
  /// half; none if it has neither.
  [[nodiscard]] Feature radiusFeature(const MtgVertex& vertex) const;
};

/// The finite number that a feature has; none if there is none.
/// @throws Error if the value is no number, or beyond any plant
[[nodiscard]] std::optional<double>
mtgNumber(const MtgVertex& vertex, const MtgGeometry::Feature& feature, const std::string& file);

/// @throws Error if a coordinate is no number
[[nodiscard]] std::optional<Eigen::Vector3d>
mtgPosition(const MtgVertex& vertex, const MtgGeometry& geometry, const std::string& file);

} // namespace espalier
