#include "ui/panels/number_field.h"

#include "ui/document/number_box.h"
#include "ui/panels/option_slider.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// Digits after the point that distinguish values of this size.
int decimalsFor(const Option& option, double size) {
  if (option.kind == OptionKind::count) return 0;
  if (option.kind == OptionKind::angle) return 1;
  if (option.kind != OptionKind::length || size <= 0) return 2;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
}

/// The values of the field that are in the range of the option: a field rounds the ends of its
/// range as it does its value.
std::pair<double, double> rangeWithin(const QDoubleSpinBox& number, const Option& option,
                                      const PlantScale& scale) {
  const auto [minimum, maximum] = option.range(scale);
  const double unit = std::pow(10, -number.decimals());
  const double slack = 1e-6; // of a digit: ends that are values stay
  const double least = std::ceil(minimum / unit - slack) * unit;
  const double most = std::floor(maximum / unit + slack) * unit;
  return least <= most ? std::pair(least, most) : std::pair(minimum, maximum);
}

} // namespace

void dress(QDoubleSpinBox& number, const Option& option, const PlantScale& scale,
           const QString& unit) {
  const auto [minimum, maximum] = option.range(scale);
  const double standard = option.rule.value(scale);
  const QString suffix = option.kind == OptionKind::angle    ? QStringLiteral("°")
                         : option.kind == OptionKind::length ? unit
                                                             : QString();
  number.setDecimals(decimalsFor(option, standard > 0 ? standard : maximum / 100));
  const auto [least, most] = rangeWithin(number, option, scale);
  number.setRange(least, most);
  number.setSuffix(suffix.isEmpty() || suffix == "°" ? suffix : QChar(0x202f) + suffix);
  number.setSingleStep(option.kind == OptionKind::count ? 1 : std::max(standard, minimum) / 10);
}

NumberField::NumberField(const Option& option, QGridLayout& grid, QWidget& parent)
    : OptionField(option, parent), slider_(new OptionSlider(&parent)),
      number_(new NumberBox(&parent)) {
  number_->setObjectName(QString::fromStdString(option.name));
  number_->setKeyboardTracking(false);
  number_->setAlignment(Qt::AlignRight);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setFixedWidth(84);
  number_->setMostDigits(5);
  number_->setAccessibleName(label().text());
  number_->findChild<QLineEdit*>()->installEventFilter(this);
  slider_->setAccessibleName(label().text());
  slider_->setMinimumWidth(48);
  label().setBuddy(number_);
  const int row = grid.rowCount();
  addHead(grid, row, label());
  grid.addWidget(slider_, row + 1, 0);
  grid.addWidget(number_, row + 1, 1);
  connect(slider_, &QSlider::valueChanged, this, [this] { choose(valueAt(slider_->place())); });
  connect(slider_, &OptionSlider::defaultRequested, this, [this] { choose(std::nullopt); });
  connect(number_->findChild<QLineEdit*>(), &QLineEdit::textEdited, this,
          [this](const QString& text) { typed_ = text; });
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double number) {
    const std::optional<Rule> rule = takeTypedRule();
    choose(rule.value_or(fixedAt(number)));
  });
  connect(number_, &QDoubleSpinBox::editingFinished, this, [this] { // the number may be as it was
    if (const std::optional<Rule> rule = takeTypedRule()) choose(rule);
  });
}

std::optional<Rule> NumberField::takeTypedRule() {
  QString text = std::exchange(typed_, QString());
  if (text.endsWith(number_->suffix())) text.chop(number_->suffix().size());
  const std::optional<Rule> rule = ruleIn(text.toStdString());
  if (option().kind != OptionKind::length || !rule || rule->isFixed()) return std::nullopt;
  const double exactness = std::pow(10, -number_->decimals()); // else it is out of range
  const bool isTaken = std::abs(rule->value(scale()) - number_->value()) <= exactness;
  return isTaken ? rule : std::nullopt;
}

std::optional<QString> NumberField::allowed() const {
  if (isInRange() && !isBrokenCount()) return std::nullopt;
  const auto [least, most] = rangeWithin(*number_, option(), scale());
  if (isBrokenCount())
    return tr("a whole number, %1 to %2")
        .arg(number_->locale().toString(least, 'f', 0), number_->locale().toString(most, 'f', 0));
  return tr("%1 to %2")
      .arg(number_->textFromValue(least), number_->textFromValue(most) + number_->suffix());
}

bool NumberField::isInRange() const {
  const auto [minimum, maximum] = option().range(scale());
  return minimum <= value() && value() <= maximum;
}

bool NumberField::isBrokenCount() const {
  return option().kind == OptionKind::count && value() != std::round(value());
}

/// A double click takes the whole number, not the digits on one side of its point.
bool NumberField::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::MouseButtonDblClick) return OptionField::eventFilter(watched, event);
  number_->selectAll();
  return true;
}

void NumberField::showScale(const QString& unit) {
  const QSignalBlocker quiet(number_);
  dress(*number_, option(), scale(), unit);
  if (option().kind == OptionKind::length) number_->setScale(scale());
  slider_->setDefaultPlace(placeOf(option().rule.value(scale())));
  slider_->setToolTip(help());
  number_->setToolTip(help());
}

// Lengths matter by their ratio, so the slider is logarithmic; where 0 is allowed it is cubic.
double NumberField::placeOf(double value) const {
  const auto [minimum, maximum] = option().range(scale());
  if (maximum <= minimum) return 0;
  if (option().kind != OptionKind::length) return (value - minimum) / (maximum - minimum);
  if (minimum > 0) return std::log(value / minimum) / std::log(maximum / minimum);
  return std::cbrt(value / maximum);
}

double NumberField::valueAt(double place) const {
  const auto [minimum, maximum] = option().range(scale());
  double value = minimum + place * (maximum - minimum);
  if (option().kind == OptionKind::length)
    value = minimum > 0 ? minimum * std::pow(maximum / minimum, place)
                        : maximum * place * place * place;
  const double unit = std::pow(10, -number_->decimalsOf(value));
  return std::clamp(std::round(value / unit) * unit, minimum, maximum);
}

void NumberField::showValue() {
  const QSignalBlocker quietSlider(slider_);
  const QSignalBlocker quietNumber(number_);
  if (option().kind == OptionKind::count) number_->setDecimals(isBrokenCount() ? 2 : 0);
  const auto [least, most] = rangeWithin(*number_, option(), scale());
  if (isInRange())
    number_->setRange(least, most);
  else // is shown, too
    number_->setRange(std::min(least, value()), std::max(most, value()));
  slider_->setPlace(std::clamp(placeOf(value()), 0.0, 1.0));
  number_->setValue(value());
}

} // namespace espalier
