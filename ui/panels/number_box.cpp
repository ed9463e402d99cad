#include "ui/panels/number_box.h"

#include "ui/document/length_unit.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QToolTip>

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

/// How many of `unit` a number with these letters behind it is in; none: they name no unit.
std::optional<double> factorOf(const QString& letters, LengthUnit unit) {
  if (letters.isEmpty()) return 1;
  const LengthUnit typed = unitOfSymbol(letters);
  if (typed == LengthUnit::unknown || unit == LengthUnit::unknown) return std::nullopt;
  return metersIn(typed) / metersIn(unit);
}

std::optional<double> numberOf(QString digits) {
  bool isNumber = false;
  const double value = digits.replace(',', '.').toDouble(&isNumber);
  return isNumber ? std::optional(value) : std::nullopt;
}

} // namespace

NumberBox::Typed NumberBox::read(const QString& text) const {
  static const QRegularExpression form(
      R"(^([-+]?[0-9]*[.,]?[0-9]*(?:[eE][-+]?[0-9]*)?)\s*([a-z]*)$)");
  QString rest = text;
  if (!suffix().isEmpty() && rest.endsWith(suffix())) rest.chop(suffix().size());
  const QRegularExpressionMatch match = form.match(rest.trimmed());
  if (!match.hasMatch()) return {QValidator::Invalid, std::nullopt};
  const QString letters = match.captured(2);
  const LengthUnit unit = unitOfSymbol(suffix().trimmed());
  const std::optional<double> factor = factorOf(letters, unit);
  if (!factor) {
    const bool isBegun = letters == "c" && unit != LengthUnit::unknown;
    return {isBegun ? QValidator::Intermediate : QValidator::Invalid, std::nullopt};
  }
  const std::optional<double> number = numberOf(match.captured(1));
  if (!number) return {QValidator::Intermediate, std::nullopt};
  const double value = *number * *factor;
  const bool isIn = value >= minimum() && value <= maximum();
  return {isIn ? QValidator::Acceptable : QValidator::Intermediate, value};
}

QValidator::State NumberBox::validate(QString& text, int& /*cursor*/) const {
  return read(text).state;
}

double NumberBox::valueFromText(const QString& text) const {
  return read(text).value.value_or(value());
}

void NumberBox::fixup(QString& text) const {
  if (const std::optional<double> typed = read(text).value)
    text = textFromValue(std::clamp(*typed, minimum(), maximum())) + suffix();
}

QString NumberBox::taken() const {
  const QString range = tr("%1 to %2").arg(textFromValue(minimum()), textFromValue(maximum()));
  if (suffix().isEmpty()) return tr("A number from %1").arg(range);
  if (unitOfSymbol(suffix().trimmed()) == LengthUnit::unknown)
    return tr("A number from %1").arg(range + suffix());
  return tr("A number from %1; also in mm, cm or m").arg(range + suffix());
}

void NumberBox::keyPressEvent(QKeyEvent* event) {
  const QString before = lineEdit()->text();
  QDoubleSpinBox::keyPressEvent(event);
  const QString typed = event->text();
  const bool isRefused =
      !typed.isEmpty() && typed.front().isPrint() && lineEdit()->text() == before;
  if (isRefused) QToolTip::showText(mapToGlobal(rect().bottomLeft()), taken(), this);
}

} // namespace espalier
