#pragma once

#include <QString>

#include <cstddef>
#include <cstdint>

namespace espalier {

/// The unit of the coordinates of a document. Display only: coordinates are never rescaled.
enum class LengthUnit { unknown, millimeter, centimeter, meter };

/// "mm", "cm", "m"; empty if unknown.
[[nodiscard]] QString symbol(LengthUnit unit);

/// The unit with this symbol; unknown for any other text.
[[nodiscard]] LengthUnit unitOfSymbol(const QString& symbol);

/// 0 if unknown.
[[nodiscard]] double metersIn(LengthUnit unit);

/// A length as people read it, to `digits` significant digits and no exponent: "12.4 mm".
[[nodiscard]] QString formatLength(double length, LengthUnit unit, int digits = 4);

/// A volume [L^3] as people read it, to three digits: in cm³, dm³ or m³, or without a unit if that
/// is not known.
[[nodiscard]] QString formatVolume(double volume, LengthUnit unit);

/// A count with its digits in threes: "147 989".
[[nodiscard]] QString formatCount(std::size_t count);

/// A size of a file or in memory as people read it, to three digits: "33.9 MB", of 1000 kB each.
[[nodiscard]] QString formatBytes(std::uint64_t bytes);

} // namespace espalier
