#include "app/report/report_numbers.h"

#include "ui/document/length_unit.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr QChar thin(0x202f); // narrow, and no line ends there
constexpr QChar minus(0x2212);

/// "12345.6" with its whole part in threes from 10 000 on.
QString inThrees(QString number) {
  const qsizetype first = number.startsWith('-') ? 1 : 0;
  const qsizetype point = number.indexOf('.');
  const qsizetype end = point < 0 ? number.size() : point;
  if (end - first < 5) return number;
  for (qsizetype at = end - 3; at > first; at -= 3)
    number.insert(at, thin);
  return number;
}

} // namespace

QString ReportNumbers::number(double value, int digits) const {
  int decimals = 0;
  if (value != 0 && std::isfinite(value))
    decimals =
        std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 6);
  QString text = QString::number(value, 'f', decimals);
  if (text.startsWith('-') && text.toDouble() == 0) text.remove(0, 1);
  return inThrees(text).replace('-', minus);
}

QString ReportNumbers::length(double value, int digits) const {
  return unit_.isEmpty() ? number(value, digits) : number(value, digits) + thin + unit_;
}

QString ReportNumbers::given(double value) const {
  QString text = number(value);
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.')))
    text.chop(1);
  return text;
}

QString ReportNumbers::givenLength(double value) const {
  return unit_.isEmpty() ? given(value) : given(value) + thin + unit_;
}

QString ReportNumbers::count(std::size_t count) const {
  return inThrees(QString::number(count));
}

QString ReportNumbers::share(double value, int decimals) const {
  return QString::number(value, 'f', decimals);
}

QString ReportNumbers::percent(double share) const {
  return QString::number(100 * share, 'f', 1) + thin + '%';
}

QString ReportNumbers::difference(double found, double expected) const {
  if (expected == 0) return found == 0 ? percent(0) : QStringLiteral("–");
  const double part = found / expected - 1;
  QString text = percent(std::abs(part));
  if (text.startsWith(QLatin1String("0.0"))) return text;
  return (part < 0 ? minus : QChar('+')) + text;
}

QString ReportNumbers::range(const ScoreInterval& interval) const {
  return QCoreApplication::translate("Report", "%1 to %2")
      .arg(share(interval.low), share(interval.high));
}

QString ReportNumbers::degrees(double radians) const {
  return QString::number(radians * 180 / std::numbers::pi, 'f', 1) + QChar(0xb0);
}

QString ReportNumbers::inUnit(const QString& name, int power) const {
  if (unit_.isEmpty()) return name;
  const QString raised = power == 2 ? QStringLiteral("²") : power == 3 ? QStringLiteral("³") : "";
  return name + QStringLiteral(" [") + unit_ + raised + ']';
}

} // namespace espalier
