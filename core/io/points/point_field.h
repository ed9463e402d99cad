#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace espalier {

/// What a column of a point file holds.
enum class PointField : std::uint8_t {
  none,
  x,
  y,
  z,
  intensity,
  red,
  green,
  blue,
  packedColor,
  station
};

/// The field that a column of this name holds in the files of scanners and of other programs:
/// "x", "Intensity", "scalar_Intensity", "diffuse_red", "R" ... Case does not matter.
[[nodiscard]] PointField pointFieldNamed(std::string_view name);

/// The name it has in messages and on the command line, which pointFieldNamed() knows; "-" of a
/// column that is left out.
[[nodiscard]] std::string_view nameOf(PointField field);

[[nodiscard]] constexpr std::size_t indexOf(PointField field) {
  return static_cast<std::size_t>(field);
}

} // namespace espalier
