#include "ui/document/length_unit.h"

#include "core/pipeline/typed_value.h"
#include "ui/document/number_scale.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {
namespace {

constexpr std::array units = {LengthUnit::millimeter, LengthUnit::centimeter, LengthUnit::meter};

struct LengthUnitText {
  Q_DECLARE_TR_FUNCTIONS(LengthUnitText)
};

} // namespace

QString symbol(LengthUnit unit) {
  switch (unit) {
  case LengthUnit::millimeter:
    return QStringLiteral("mm");
  case LengthUnit::centimeter:
    return QStringLiteral("cm");
  case LengthUnit::meter:
    return QStringLiteral("m");
  case LengthUnit::unknown:
    break;
  }
  return {};
}

LengthUnit unitOfSymbol(const QString& text) {
  const auto* found =
      std::ranges::find_if(units, [&](LengthUnit unit) { return symbol(unit) == text; });
  return found == units.end() ? LengthUnit::unknown : *found;
}

double metersIn(LengthUnit unit) {
  return metersIn(symbol(unit).toStdString());
}

QString formatLength(double length, LengthUnit unit, int digits) {
  int decimals = 0;
  if (length != 0 && std::isfinite(length))
    decimals =
        std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(length)))), 0, 6);
  const QString number = numberText(length, decimals);
  return unit == LengthUnit::unknown ? number : number + QChar(0x202f) + symbol(unit);
}

QString formatVolume(double volume, LengthUnit unit) {
  constexpr int digits = 3;
  if (unit == LengthUnit::unknown) return formatLength(volume, unit, digits);
  const double liters = 1e3 * std::pow(metersIn(unit), 3) * volume;
  const auto written = [](double value, const char* name) {
    return formatLength(value, LengthUnit::unknown, digits) + QChar(0x202f) +
           QString::fromUtf8(name);
  };
  if (liters >= 1000) return written(liters / 1000, "m³");
  if (liters >= 1) return written(liters, "dm³");
  return written(1000 * liters, "cm³");
}

QString formatCount(std::size_t count) {
  return numberText(static_cast<double>(count), 0);
}

QString formatBytes(std::uint64_t bytes) {
  const auto number = [&](double unit) {
    return formatLength(static_cast<double>(bytes) / unit, LengthUnit::unknown, 3);
  };
  if (bytes == 1) return LengthUnitText::tr("1 byte");
  if (bytes < 1000) return LengthUnitText::tr("%1 bytes").arg(bytes);
  if (bytes < 1'000'000) return LengthUnitText::tr("%1 kB").arg(number(1e3));
  if (bytes < 1'000'000'000) return LengthUnitText::tr("%1 MB").arg(number(1e6));
  return LengthUnitText::tr("%1 GB").arg(number(1e9));
}

} // namespace espalier
