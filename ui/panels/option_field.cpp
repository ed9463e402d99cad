#include "ui/panels/option_field.h"

#include "ui/panels/option_slider.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// Digits after the point that tell values of this size apart.
int decimalsFor(const Option& option, double size) {
  if (option.kind == OptionKind::count) return 0;
  if (option.kind == OptionKind::angle) return 1;
  if (option.kind == OptionKind::ratio || size <= 0) return 2;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
}

} // namespace

OptionField::OptionField(const Option& option, QGridLayout& grid, QWidget& parent)
    : QObject(&parent), option_(option),
      label_(new QLabel(QString::fromStdString(option.label), &parent)),
      slider_(new OptionSlider(&parent)), number_(new QDoubleSpinBox(&parent)),
      reset_(new QToolButton(&parent)) {
  number_->setObjectName(QString::fromStdString(option.name));
  number_->setKeyboardTracking(false);
  number_->setAlignment(Qt::AlignRight);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setFixedWidth(84);
  number_->setAccessibleName(label_->text());
  slider_->setAccessibleName(label_->text());
  slider_->setMinimumWidth(48);
  reset_->setText(QStringLiteral("↺"));
  reset_->setAutoRaise(true);
  reset_->setFixedSize(20, 20);
  reset_->setToolTip(tr("Back to the default"));
  reset_->setAccessibleName(tr("Back to the default"));
  QSizePolicy keepsPlace = reset_->sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true); // so that columns do not jump
  reset_->setSizePolicy(keepsPlace);
  label_->setBuddy(number_);
  const int row = grid.rowCount();
  grid.addWidget(label_, row, 0);
  grid.addWidget(reset_, row, 1, Qt::AlignRight);
  grid.addWidget(slider_, row + 1, 0);
  grid.addWidget(number_, row + 1, 1);
  connect(slider_, &QSlider::valueChanged, this, [this] { choose(valueAt(slider_->place())); });
  connect(slider_, &OptionSlider::defaultRequested, this, [this] { choose(std::nullopt); });
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double typed) { choose(typed); });
  connect(reset_, &QToolButton::clicked, this, [this] { choose(std::nullopt); });
  setScale(scale_, {});
}

void OptionField::setScale(const PlantScale& scale, const QString& unit) {
  scale_ = scale;
  const auto [minimum, maximum] = option_.range(scale_);
  const double standard = option_.rule.value(scale_);
  const QString suffix = option_.kind == OptionKind::angle    ? QStringLiteral("°")
                         : option_.kind == OptionKind::length ? unit
                                                              : QString();
  const QSignalBlocker quiet(number_);
  number_->setDecimals(decimalsFor(option_, standard > 0 ? standard : maximum / 100));
  number_->setRange(minimum, maximum);
  number_->setSuffix(suffix.isEmpty() || suffix == "°" ? suffix : QChar(0x202f) + suffix);
  number_->setSingleStep(option_.kind == OptionKind::count ? 1 : std::max(standard, minimum) / 10);
  slider_->setDefaultPlace(placeOf(standard));
  const QString help = tr("<qt>%1<br>Default: %2</qt>") // rich, so that it is broken into lines
                           .arg(QString::fromStdString(option_.help).toHtmlEscaped(),
                                QString::fromStdString(option_.rule.text()).toHtmlEscaped());
  label_->setToolTip(help);
  slider_->setToolTip(help);
  number_->setToolTip(help);
  if (chosen_) chosen_ = std::clamp(*chosen_, minimum, maximum);
  showValue();
}

void OptionField::choose(std::optional<double> value) {
  chosen_ = value;
  showValue();
  emit changed();
}

double OptionField::value() const {
  return chosen_.value_or(option_.rule.value(scale_));
}

// Lengths matter by their ratio, so the slider is logarithmic; where 0 is allowed it is cubic.
double OptionField::placeOf(double value) const {
  const auto [minimum, maximum] = option_.range(scale_);
  if (maximum <= minimum) return 0;
  if (option_.kind != OptionKind::length) return (value - minimum) / (maximum - minimum);
  if (minimum > 0) return std::log(value / minimum) / std::log(maximum / minimum);
  return std::cbrt(value / maximum);
}

double OptionField::valueAt(double place) const {
  const auto [minimum, maximum] = option_.range(scale_);
  double value = minimum + place * (maximum - minimum);
  if (option_.kind == OptionKind::length)
    value = minimum > 0 ? minimum * std::pow(maximum / minimum, place)
                        : maximum * place * place * place;
  const double unit = std::pow(10, -number_->decimals());
  return std::clamp(std::round(value / unit) * unit, minimum, maximum);
}

void OptionField::showValue() {
  const QSignalBlocker quietSlider(slider_);
  const QSignalBlocker quietNumber(number_);
  slider_->setPlace(std::clamp(placeOf(value()), 0.0, 1.0));
  number_->setValue(value());
  reset_->setVisible(chosen_.has_value());
}

} // namespace espalier
