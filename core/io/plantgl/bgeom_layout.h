#pragma once

#include <optional>
#include <string_view>

namespace espalier {

/// How an object of a binary scene of PlantGL lies in the file, behind its name and ident.
///
/// `fields` are words. A letter states the type: r real, u 32 bits, b byte, c color of 3 bytes, s
/// text, d v w 2, 3, 4 reals, o object; a capital an array of them behind their number, C of colors
/// of 4 bytes, T Q of 3 or 4 indices, X of arrays of indices, m M a matrix of reals or of 4 reals
/// behind rows and columns. "4:" before it: there only if bit 4 (hexadecimal) of the mask is clear;
/// "@17" behind it: only since version 1.7.
struct BgeomLayout {
  std::string_view type;
  int maskBytes = 0; // before the fields
  std::string_view fields;
  bool isShape = true; // that is seen: else a material and the like
};

/// The layout of objects that are passed over; none if it is not known in this version.
/// @param version  1.7 as 17
[[nodiscard]] std::optional<BgeomLayout> bgeomLayoutOf(std::string_view type, int version);

} // namespace espalier
