#include "ui/panels/explained_bar.h"

#include "ui/panels/number_box.h"
#include "ui/panels/option_slider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double usual = 4;   // spacings
constexpr double widest = 64; // spacings, at the end of the slider

/// Small distances get most of the slider.
double placeOf(double spacings) {
  return std::sqrt(std::clamp(spacings / widest, 0.0, 1.0));
}

} // namespace

ExplainedBar::ExplainedBar(QWidget* parent)
    : QFrame(parent), slider_(new OptionSlider), number_(new NumberBox), hide_(new QToolButton),
      left_(new QLabel) {
  setObjectName("explained_bar");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 4, 4, 4);
  row->setSpacing(8);
  row->addStretch();
  auto* title = new QLabel(tr("Explained within"));
  title->setToolTip(tr("Points this near to the surface of the wood are explained by it"));
  row->addWidget(title);
  slider_->setObjectName("explained_slider");
  slider_->setAccessibleName(tr("Distance to the skeleton"));
  slider_->setFixedWidth(120);
  slider_->setDefaultPlace(placeOf(usual));
  row->addWidget(slider_);
  number_->setObjectName("explained_number");
  number_->setAccessibleName(tr("Distance to the skeleton"));
  number_->setKeyboardTracking(false);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setFixedWidth(88);
  row->addWidget(number_);
  hide_->setObjectName("explained_hide");
  hide_->setProperty("role", "panel");
  hide_->setText(tr("Hide"));
  hide_->setToolTip(tr("Hides explained points instead of dimming them"));
  hide_->setCheckable(true);
  row->addWidget(hide_);
  left_->setObjectName("explained_left");
  left_->setProperty("role", "quiet");
  row->addWidget(left_);
  auto* close = new QPushButton(QStringLiteral("✕"));
  close->setObjectName("explained_close");
  close->setAccessibleName(tr("Close"));
  close->setToolTip(tr("Shows all points as usual"));
  close->setFlat(true);
  row->addStretch();
  row->addWidget(close);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    const double place = slider_->place();
    choose(place * place * widest * spacing_);
  });
  connect(slider_, &OptionSlider::defaultRequested, this, [this] { choose(std::nullopt); });
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { choose(value); });
  connect(hide_, &QToolButton::toggled, this, &ExplainedBar::changed);
  connect(close, &QPushButton::clicked, this, &ExplainedBar::closeRequested);
  showDistance();
}

void ExplainedBar::setSpacing(double spacing, const QString& unit) {
  if (spacing > 0) spacing_ = spacing;
  const QSignalBlocker blocker(number_);
  number_->setSuffix(unit.isEmpty() ? QString() : QChar(0x202f) + unit);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(spacing_))), 0, 9);
  number_->setDecimals(decimals);
  number_->setRange(0, 1000 * spacing_);
  number_->setSingleStep(std::pow(10, std::floor(std::log10(spacing_))));
  showDistance();
}

void ExplainedBar::forgetDistance() {
  chosen_.reset();
  showDistance();
}

double ExplainedBar::distance() const {
  return chosen_.value_or(usual * spacing_);
}

bool ExplainedBar::isHiding() const {
  return hide_->isChecked();
}

void ExplainedBar::setHiding(bool isHiding) {
  hide_->setChecked(isHiding);
}

void ExplainedBar::showLeft(const QString& text) {
  left_->setText(text);
  left_->setVisible(!text.isEmpty());
}

void ExplainedBar::choose(std::optional<double> distance) {
  chosen_ = distance;
  showDistance();
  emit changed();
}

void ExplainedBar::showDistance() {
  const QSignalBlocker quietSlider(slider_);
  const QSignalBlocker quietNumber(number_);
  slider_->setPlace(placeOf(distance() / spacing_));
  number_->setValue(distance());
}

} // namespace espalier
