#include "ui/panels/trait_text.h"

#include "ui/document/number_scale.h"

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

/// In mm², cm² or m², as volumes are, or without a unit if that is not known.
QString areaText(double area, LengthUnit unit) {
  const auto written = [](double value, const char* name) {
    return formatLength(value, LengthUnit::unknown, 3) + QString::fromUtf8(name);
  };
  if (unit == LengthUnit::unknown) return written(area, "");
  const double squareMeters = std::pow(metersIn(unit), 2) * area;
  if (squareMeters >= 0.1) return written(squareMeters, "\u202fm²");
  if (squareMeters >= 1e-4) return written(1e4 * squareMeters, "\u202fcm²");
  return written(1e6 * squareMeters, "\u202fmm²");
}

} // namespace

QString textOf(const TraitRow& row, LengthUnit unit) {
  switch (row.kind) {
  case TraitKind::count:
    return formatCount(static_cast<std::size_t>(row.value));
  case TraitKind::share:
    return numberText(row.value, 3);
  case TraitKind::length:
    return formatLength(row.value, unit, 3);
  case TraitKind::area:
    return areaText(row.value, unit);
  case TraitKind::volume:
    return formatVolume(row.value, unit);
  case TraitKind::angle:
    return numberText(row.value * 180 / std::numbers::pi, 1) + QChar(0xb0);
  }
  return {};
}

} // namespace espalier
