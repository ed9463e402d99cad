#include "ui/panels/clip_panel.h"

#include "ui/document/number_box.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr int clipSteps = 200; // of a slider from 0 to 1

int stepOf(double part) {
  return static_cast<int>(std::lround(part * clipSteps));
}

} // namespace

ClipPanel::ClipPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("clip_panel");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 8, 12, 12);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  addSlab(*grid);
  addBox(*grid);
  fade_ = addSlider(*grid, "clip_fade", tr("Fade"), 0);
  fade_->setToolTip(tr("The farther back, the paler"));
  fade_->setAccessibleName(tr("Fade by depth"));
  around_ = addSlider(*grid, "clip_around", tr("Around"), 0);
  around_->setToolTip(tr("How pale the rest gets when you go to a finding, a doubt or a stop of "
                         "the review: what is nearer or farther, and not of the same branch"));
  around_->setAccessibleName(tr("Fade around what one flew to"));
  auto* all = new QPushButton(tr("Show All Again"));
  all->setObjectName("clip_show_all");
  grid->addWidget(all, grid->rowCount(), 0, 1, 3);
  grid->setRowStretch(grid->rowCount(), 1);
  connect(all, &QPushButton::clicked, this, &ClipPanel::showAllRequested);
  refresh();
}

void ClipPanel::addSlab(QGridLayout& grid) {
  slab_ = new QCheckBox(tr("Slab facing the viewer"));
  slab_->setObjectName("clip_slab_on");
  slab_->setToolTip(tr("Shows what is neither nearer nor farther; turns with the view"));
  grid.addWidget(slab_, 0, 0, 1, 3);
  nearest_ = addSlider(grid, "clip_nearest", tr("Front"), 0);
  farthest_ = addSlider(grid, "clip_farthest", tr("Back"), clipSteps);
  for (QSlider* slider : {nearest_, farthest_})
    connect(slider, &QSlider::valueChanged, this, [this, slider] { keepApart(slider); });
  connect(slab_, &QCheckBox::toggled, this, [this] {
    refresh();
    emit changed();
  });
}

void ClipPanel::addBox(QGridLayout& grid) {
  box_ = new QCheckBox(tr("Box"));
  box_->setObjectName("clip_box_on");
  box_->setToolTip(tr("Shows what lies between these coordinates"));
  grid.addWidget(box_, grid.rowCount(), 0, 1, 3);
  for (int axis = 0; axis < 3; ++axis) {
    const QString name(QChar('x' + axis));
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(name), row, 0);
    const auto add = [&](const QString& end, const QString& spokenName, int column) {
      auto* field = new NumberBox;
      field->setObjectName("clip_" + name + end);
      field->setAccessibleName(spokenName.arg(name));
      field->setButtonSymbols(QAbstractSpinBox::NoButtons);
      field->setKeyboardTracking(false);
      field->setDecimals(3);
      field->setMinimumWidth(56); // with the labels no wider than the inspector
      grid.addWidget(field, row, column);
      connect(field, &QDoubleSpinBox::valueChanged, this, &ClipPanel::changed);
      return field;
    };
    low_[std::size_t(axis)] = add("_low", tr("Least %1"), 1);
    high_[std::size_t(axis)] = add("_high", tr("Greatest %1"), 2);
  }
  connect(box_, &QCheckBox::toggled, this, [this] {
    refresh();
    emit changed();
  });
}

QSlider* ClipPanel::addSlider(QGridLayout& grid, const QString& name, const QString& label,
                              int value) {
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setObjectName(name);
  slider->setAccessibleName(label);
  slider->setRange(0, clipSteps);
  slider->setPageStep(clipSteps / 10);
  slider->setValue(value);
  const int row = grid.rowCount();
  grid.addWidget(new QLabel(label), row, 0);
  grid.addWidget(slider, row, 1, 1, 2);
  connect(slider, &QSlider::valueChanged, this, &ClipPanel::changed);
  return slider;
}

/// The slab keeps some thickness: the other side moves with it.
void ClipPanel::keepApart(const QSlider* moved) {
  constexpr int least = 2;
  if (farthest_->value() - nearest_->value() >= least) return;
  if (moved == nearest_) {
    farthest_->setValue(nearest_->value() + least);
    nearest_->setValue(farthest_->value() - least);
  } else {
    nearest_->setValue(farthest_->value() - least);
    farthest_->setValue(nearest_->value() + least);
  }
}

void ClipPanel::refresh() {
  for (QSlider* slider : {nearest_, farthest_})
    slider->setEnabled(slab_->isChecked());
  for (const auto& fields : {low_, high_})
    for (QDoubleSpinBox* field : fields)
      field->setEnabled(box_->isChecked());
}

void ClipPanel::setBounds(const Eigen::AlignedBox3d& bounds) {
  if (bounds.isEmpty()) return;
  const double size = std::max(bounds.sizes().maxCoeff(), 1e-6);
  const int digits = std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
  const double unit = std::pow(10, -digits); // what the fields can show: the box cuts nothing
  bounds_ = {(bounds.min() / unit).array().floor().matrix() * unit,
             (bounds.max() / unit).array().ceil().matrix() * unit};
  for (int axis = 0; axis < 3; ++axis)
    for (QDoubleSpinBox* field : {low_[std::size_t(axis)], high_[std::size_t(axis)]}) {
      const QSignalBlocker quiet(field);
      field->setDecimals(digits);
      field->setRange(bounds_.min()[axis] - size, bounds_.max()[axis] + size);
      field->setSingleStep(size / 100);
      const bool isLow = field == low_[std::size_t(axis)];
      if (!box_->isChecked()) field->setValue(isLow ? bounds_.min()[axis] : bounds_.max()[axis]);
    }
}

void ClipPanel::setUnit(const QString& unit) {
  box_->setText(unit.isEmpty() ? tr("Box") : tr("Box [%1]").arg(unit));
}

void ClipPanel::setValues(const Values& values) {
  const QSignalBlocker quiet(this);
  slab_->setChecked(values.hasSlab);
  nearest_->setValue(stepOf(values.nearest));
  farthest_->setValue(stepOf(values.farthest));
  nearest_->setValue(stepOf(values.nearest)); // both sides are where they may be now
  box_->setChecked(values.hasBox);
  const Eigen::AlignedBox3d& box = values.box.isEmpty() ? bounds_ : values.box;
  for (int axis = 0; axis < 3 && !box.isEmpty(); ++axis) {
    low_[std::size_t(axis)]->setValue(box.min()[axis]);
    high_[std::size_t(axis)]->setValue(box.max()[axis]);
  }
  fade_->setValue(stepOf(values.fade));
  around_->setValue(stepOf(values.around));
  refresh();
}

ClipPanel::Values ClipPanel::values() const {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = low_[std::size_t(axis)]->value();
    const double b = high_[std::size_t(axis)]->value();
    box.min()[axis] = std::min(a, b);
    box.max()[axis] = std::max(a, b);
  }
  return {.hasSlab = slab_->isChecked(),
          .nearest = double(nearest_->value()) / clipSteps,
          .farthest = double(farthest_->value()) / clipSteps,
          .hasBox = box_->isChecked(),
          .box = box,
          .fade = double(fade_->value()) / clipSteps,
          .around = double(around_->value()) / clipSteps};
}

} // namespace espalier
