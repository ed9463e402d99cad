#include "ui/dialogs/scan_look.h"

#include "core/base/text.h"
#include "core/io/points/point_field.h"
#include "ui/document/shown_message.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

struct ScanLookText {
  Q_DECLARE_TR_FUNCTIONS(ScanLookText)
};

/// Of cloud, index and picture, without a skeleton.
constexpr std::uint64_t bytesPerPoint = 100;

QString doubtText(ColumnDoubt doubt) {
  switch (doubt) {
  case ColumnDoubt::notNumbers:
    return ScanLookText::tr(
        "The first three columns are not all numbers: choose below which hold x, y "
        "and z.");
  case ColumnDoubt::otherNames:
    return ScanLookText::tr(
        "The first line names the columns, but none x, y and z: check below which "
        "they are.");
  case ColumnDoubt::twoPlaces:
    return ScanLookText::tr(
        "Columns 4 to 6 could be the color, or columns 5 to 7: check below which "
        "they are.");
  case ColumnDoubt::withoutName:
    return ScanLookText::tr(
        "Nothing names the columns, and some are left out: check below what they "
        "hold.");
  case ColumnDoubt::none:
    break;
  }
  return {};
}

bool isIntensity(const QString& name) {
  return pointFieldNamed(name.toStdString()) == PointField::intensity || name.contains("intensity");
}

bool isColor(const QString& name) {
  return name.contains("red") || pointFieldNamed(name.toStdString()) == PointField::red ||
         pointFieldNamed(name.toStdString()) == PointField::packedColor;
}

bool hasColumn(const PointGlance& glance, bool (*isIt)(const QString&)) {
  return std::ranges::any_of(glance.columns, [&](const GlanceColumn& column) {
    return column.isTaken && isIt(QString::fromStdString(column.name).toLower());
  });
}

QString sides(const Eigen::Vector3d& lengths, LengthUnit unit) {
  const auto side = [&](int axis) {
    return formatLength(lengths[axis], axis == 2 ? unit : LengthUnit::unknown, 3);
  };
  return QStringLiteral("%1 × %2 × %3").arg(side(0), side(1), side(2));
}

} // namespace

PointGlance glanceOf(const ScanLook& look) {
  PointGlance glance = look.glance;
  const ShownMessage reason{Shown::tr("as the open scan")};
  if (look.unit) glance.unit = {symbol(*look.unit).toStdString(), reason, true};
  if (look.up) glance.up = {std::string(1, "xyz"[static_cast<int>(*look.up)]), reason, true};
  return glance;
}

QString columnsQuestion(const ScanLook& look) {
  if (!look.text) return {};
  const FirstLines& text = *look.text;
  if (text.doubt != ColumnDoubt::none && look.columns.empty()) return doubtText(text.doubt);
  const bool areRead = std::ranges::all_of(text.lines, [&](const TextLine& line) {
    return line.kind != TextLine::Kind::points ||
           isPoint(line, look.columns.empty() ? text.columns : look.columns, text.hasDecimalComma);
  });
  return areRead ? QString()
                 : ScanLookText::tr(
                       "Some lines cannot be read with these columns: choose others below.");
}

QStringList questionsOf(const ScanLook& look, std::uint64_t mostAtOnce) {
  QStringList questions;
  if (const QString columns = columnsQuestion(look); !columns.isEmpty()) questions.append(columns);
  if (look.glance.points > mostAtOnce)
    questions.append(
        ScanLookText::tr(
            "It has %1 points, more than are read without asking: choose below how many.")
            .arg(pointsText(look.glance.points, look.glance.arePointsEstimated)));
  const GlanceGuess& unit = look.glance.unit; // one that is stated and has no name here stays none
  if (!look.unit && unit.value.empty() && !unit.isStated && !look.glance.bounds.isEmpty())
    questions.append(ScanLookText::tr("Its unit is not known: choose it below."));
  return questions;
}

QString pointsText(std::uint64_t points, bool isEstimated) {
  const QString count = formatCount(static_cast<std::size_t>(points));
  return isEstimated ? ScanLookText::tr("about %1").arg(count) : count;
}

QString contentText(const PointGlance& glance) {
  QStringList parts = {pointsText(glance.points, glance.arePointsEstimated)};
  const bool hasIntensity = hasColumn(glance, isIntensity);
  const bool hasColor = hasColumn(glance, isColor);
  parts.append(hasIntensity && hasColor ? ScanLookText::tr("with intensity and color")
               : hasIntensity           ? ScanLookText::tr("with intensity, without color")
               : hasColor               ? ScanLookText::tr("with color, without intensity")
                                        : ScanLookText::tr("without intensity and color"));
  if (glance.stations > 1)
    parts.append(
        ScanLookText::tr("from %1 stations").arg(formatCount(std::size_t(glance.stations))));
  return parts.join(QStringLiteral(", "));
}

QString columnsText(const PointGlance& glance) {
  QStringList taken;
  QStringList leftOut;
  for (const GlanceColumn& column : glance.columns)
    (column.isTaken ? taken : leftOut).append(QString::fromStdString(column.name));
  for (const ShownMessage& other : glance.leftOut)
    leftOut.append(shownText(other));
  const QString text = taken.join(QStringLiteral(", "));
  return leftOut.isEmpty()
             ? text
             : ScanLookText::tr("%1; left out: %2").arg(text, leftOut.join(QStringLiteral(", ")));
}

QString boundsText(const PointGlance& glance) {
  if (glance.bounds.isEmpty()) return ScanLookText::tr("not known");
  QStringList axes;
  const double scale = std::pow(10.0, decimalsIn(glance.bounds));
  const auto number = [scale](double value) {
    return QString::fromStdString(plainDecimal(std::round(value * scale) / scale + 0.0)); // no -0
  };
  for (int axis = 0; axis < 3; ++axis)
    axes.append(ScanLookText::tr("%1 from %2 to %3")
                    .arg(QChar("xyz"[axis]))
                    .arg(number(glance.bounds.min()[axis]), number(glance.bounds.max()[axis])));
  const QString text = axes.join(QStringLiteral(", "));
  return glance.areBoundsOfSample ? ScanLookText::tr("%1, of a sample").arg(text) : text;
}

QString sizeText(const PointGlance& glance, LengthUnit unit) {
  if (glance.bounds.isEmpty()) return ScanLookText::tr("not known");
  const Eigen::Vector3d lengths = glance.bounds.sizes();
  QString text = sides(lengths, unit);
  if (unit == LengthUnit::unknown || unit == LengthUnit::meter) return text;
  return ScanLookText::tr("%1, which is %2")
      .arg(text, sides(lengths * metersIn(unit), LengthUnit::meter));
}

QString reasonText(const GlanceGuess& guess) {
  const QString reason = shownText(guess.reason);
  if (guess.isStated) return ScanLookText::tr("Stated: %1").arg(reason);
  if (guess.value.empty()) return ScanLookText::tr("Not known: %1").arg(reason);
  return ScanLookText::tr("Guessed: %1").arg(reason);
}

QString memoryText(std::uint64_t points) {
  return formatBytes(points * bytesPerPoint);
}

std::optional<std::uint64_t> pointsIn(const Eigen::AlignedBox3d& box, const PointGlance& glance) {
  if (glance.sample.empty()) return std::nullopt;
  const auto inside = std::ranges::count_if(
      glance.sample, [&](const Eigen::Vector3d& place) { return box.contains(place); });
  const double share = static_cast<double>(inside) / static_cast<double>(glance.sample.size());
  return static_cast<std::uint64_t>(std::llround(share * static_cast<double>(glance.points)));
}

int decimalsIn(const Eigen::AlignedBox3d& bounds) {
  const double extent = bounds.isEmpty() ? 0 : bounds.sizes().maxCoeff();
  return extent > 0 ? std::clamp(3 - static_cast<int>(std::floor(std::log10(extent))), 0, 6) : 3;
}

} // namespace espalier
