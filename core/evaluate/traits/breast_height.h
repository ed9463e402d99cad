#pragma once

#include "core/skeleton/skeleton.h"

#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// 1.3 m, where foresters measure stems, in the unit "mm", "cm" or "m" [L]; 0 for any other: not
/// known.
[[nodiscard]] double breastHeightIn(std::string_view unit);

/// Diameters of two stems at breast height (DBH).
struct StemDiameters {
  double height = 0;               // [L], above the foot of the reference
  std::optional<double> result;    // [L]; none: it has none there
  std::optional<double> reference; // [L]
  std::string missing;             // why one is none; empty if both are there

  [[nodiscard]] std::optional<double> error() const;         // [L], result less reference
  [[nodiscard]] std::optional<double> relativeError() const; // of that of the reference
};

/// Measures the stems of both at one height above the foot of the reference. Up is z.
///
/// The stem is stemOf(). Its
/// diameter is measured where it first rises to the height, and changes evenly along an edge; it is
/// that across the stem, as if it stood upright there.
///
/// @param result laid on the reference: it may begin above the ground
/// @param height [L], as breastHeightIn(); 0: nothing is measured, since the unit is not known
/// Time O(N).
[[nodiscard]] StemDiameters stemDiameters(const Skeleton& result, const Skeleton& reference,
                                          double height);

} // namespace espalier
