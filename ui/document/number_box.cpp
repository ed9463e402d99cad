#include "ui/document/number_box.h"

#include "ui/document/length_unit.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setLocale(QLocale::c());
}

/// How much one of `unit` is in this field; none: nobody knows.
std::optional<double> NumberBox::factorOf(ValueUnit unit) const {
  if (unit == ValueUnit::none) return 1;
  if (unit == ValueUnit::degrees) return suffix() == "°" ? std::optional(1.0) : std::nullopt;
  if (unit == ValueUnit::spacings) return scale_ ? std::optional(scale_->spacing) : std::nullopt;
  if (unit == ValueUnit::heights) return scale_ ? std::optional(scale_->height) : std::nullopt;
  if (unit == ValueUnit::thicknesses)
    return scale_ ? std::optional(thicknesses(1).value(*scale_)) : std::nullopt;
  if (unit == ValueUnit::scatters)
    return scale_ ? std::optional(scatters(1).value(*scale_)) : std::nullopt;
  const LengthUnit own = unitOfSymbol(suffix().trimmed());
  if (own == LengthUnit::unknown) return std::nullopt;
  return metersIn(unit) / metersIn(own);
}

NumberBox::Typed NumberBox::read(const QString& text) const {
  QString rest = text;
  if (!suffix().isEmpty() && rest.endsWith(suffix())) rest.chop(suffix().size());
  const std::string bytes = rest.toStdString();
  const TypedValue typed = typedValue(bytes);
  if (typed.state == TypedValue::State::complete)
    if (const std::optional<double> factor = factorOf(typed.unit)) {
      const double value = typed.amount * *factor;
      const bool isIn = value >= minimum() && value <= maximum();
      return {isIn ? QValidator::Acceptable : QValidator::Intermediate, value};
    }
  const std::vector<ValueUnit> units = unitsBeginning(typed.letters);
  const bool isBegun =
      typed.state != TypedValue::State::wrong && std::ranges::any_of(units, [this](ValueUnit unit) {
        return unit != ValueUnit::none && factorOf(unit).has_value();
      });
  const bool isNumberBegun = typed.state == TypedValue::State::begun && typed.letters.empty();
  return {isBegun || isNumberBegun ? QValidator::Intermediate : QValidator::Invalid, std::nullopt};
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

int NumberBox::decimalsOf(double value) const {
  const double size = std::abs(value);
  if (mostDigits_ == 0 || size < 10) return decimals();
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  return std::clamp(mostDigits_ - before, 0, decimals());
}

QString NumberBox::textFromValue(double value) const {
  const QString text = QDoubleSpinBox::textFromValue(value);
  const QString shorter = locale().toString(value, 'f', decimalsOf(value));
  const bool isTheSame = locale().toDouble(shorter) == locale().toDouble(text);
  return isTheSame ? shorter : text;
}

QString NumberBox::taken() const {
  const QString range = tr("%1 to %2").arg(textFromValue(minimum()), textFromValue(maximum()));
  const QString number = tr("A number from %1").arg(range + suffix());
  const bool isKnown = unitOfSymbol(suffix().trimmed()) != LengthUnit::unknown;
  if (isKnown && scale_)
    return tr("%1; also in mm, cm or m, or as 6 sp (spacings), 0.02 h (heights), 3 th "
              "(thicknesses of thin wood), 2 sc (scatters)")
        .arg(number);
  if (isKnown) return tr("%1; also in mm, cm or m").arg(number);
  return scale_ ? tr("%1; also as 6 sp (spacings), 0.02 h (heights), 3 th (thicknesses of thin "
                     "wood), 2 sc (scatters)")
                      .arg(number)
                : number;
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
