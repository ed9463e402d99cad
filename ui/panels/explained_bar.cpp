#include "ui/panels/explained_bar.h"

#include "ui/document/number_box.h"
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

constexpr double most = 64; // times as sensitive as usual, or as little, at the ends of the slider

/// The usual distance is in the middle, and every step as many times as far.
double placeOf(double timesUsual) {
  return 0.5 + 0.5 * std::log(std::clamp(timesUsual, 1 / most, most)) / std::log(most);
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
  title->setToolTip(tr("Points this near to the surface of the wood are explained by it. "
                       "Sets the sensitivity of all checks"));
  row->addWidget(title);
  slider_->setObjectName("explained_slider");
  slider_->setAccessibleName(tr("Distance to the skeleton"));
  slider_->setFixedWidth(120);
  slider_->setDefaultPlace(placeOf(1));
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
  connect(slider_, &QSlider::valueChanged, this,
          [this] { choose(usual_ * std::pow(most, 2 * slider_->place() - 1)); });
  connect(slider_, &OptionSlider::defaultRequested, this, [this] { choose(usual_); });
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { choose(value); });
  connect(hide_, &QToolButton::toggled, this, &ExplainedBar::changed);
  connect(close, &QPushButton::clicked, this, &ExplainedBar::closeRequested);
  showDistance();
}

void ExplainedBar::setLimits(double usual, double sensitivity, const QString& unit) {
  if (usual > 0) usual_ = usual;
  sensitivity_ = sensitivity;
  const QSignalBlocker blocker(number_);
  number_->setSuffix(unit.isEmpty() ? QString() : QChar(0x202f) + unit);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(usual_ / 3))), 0, 9);
  number_->setDecimals(decimals);
  number_->setRange(usual_ / most, usual_ * most);
  number_->setSingleStep(std::pow(10, std::floor(std::log10(usual_ / 3))));
  showDistance();
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

void ExplainedBar::choose(double distance) {
  sensitivity_ = std::clamp(usual_ / distance, 1 / most, most);
  showDistance();
  emit changed();
  emit sensitivityChosen(sensitivity_);
}

void ExplainedBar::showDistance() {
  const QSignalBlocker quietSlider(slider_);
  const QSignalBlocker quietNumber(number_);
  slider_->setPlace(placeOf(distance() / usual_));
  number_->setValue(distance());
}

} // namespace espalier
