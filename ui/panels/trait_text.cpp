#include "ui/panels/trait_text.h"

#include "ui/document/number_scale.h"

#include <numbers>

namespace espalier {
namespace {

QString areaText(double area, LengthUnit unit) {
  const QString number = formatLength(area, LengthUnit::unknown, 3);
  return unit == LengthUnit::unknown ? number
                                     : number + QChar(0x202f) + symbol(unit) + QStringLiteral("²");
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
