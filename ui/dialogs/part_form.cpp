#include "ui/dialogs/part_form.h"

#include "ui/dialogs/count_box.h"
#include "ui/dialogs/scan_look.h"
#include "ui/document/number_box.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

QLabel* quietLabel(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setProperty("role", "quiet");
  return label;
}

} // namespace

PartForm::PartForm(const PointGlance& glance, std::uint64_t mostAtOnce, QWidget* parent)
    : QWidget(parent), glance_(glance), all_(new QRadioButton(tr("All points"), this)),
      allText_(quietLabel("all_text", this)), some_(new QRadioButton(tr("At most"), this)),
      most_(new CountBox(this)), someText_(quietLabel("some_text", this)),
      isBoxed_(new QCheckBox(tr("Only what lies in a box"), this)),
      boxText_(quietLabel("box_text", this)), sides_(new QWidget(this)), ends_(), filled_() {
  all_->setObjectName("read_all");
  some_->setObjectName("read_some");
  some_->setToolTip(tr("Points from all over the scan, drawn by a lot that always falls alike"));
  isBoxed_->setObjectName("read_box");
  most_->setObjectName("read_most");
  most_->setAccessibleName(tr("At most so many points"));
  most_->setCount(std::min(mostAtOnce, std::max<std::uint64_t>(glance.points, 1)));
  (glance.points > mostAtOnce ? some_ : all_)->setChecked(true);
  makeBox();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->addWidget(all_, 0, 0, 1, 2);
  grid->addWidget(allText_, 0, 2);
  grid->addWidget(some_, 1, 0);
  grid->addWidget(most_, 1, 1);
  grid->addWidget(someText_, 1, 2);
  grid->addWidget(isBoxed_, 2, 0, 1, 2);
  grid->addWidget(boxText_, 2, 2);
  grid->addWidget(sides_, 3, 0, 1, 3);
  grid->setColumnStretch(2, 1);
  fillBox();
  for (QRadioButton* button : {all_, some_})
    connect(button, &QRadioButton::toggled, this, &PartForm::refresh);
  connect(most_, &CountBox::valueChanged, this, [this] { some_->setChecked(true); });
  connect(most_, &CountBox::valueChanged, this, &PartForm::refresh);
  connect(isBoxed_, &QCheckBox::toggled, this, &PartForm::refresh);
  refresh();
}

void PartForm::makeBox() {
  auto* row = new QGridLayout(sides_);
  row->setContentsMargins(24, 0, 0, 0);
  row->setHorizontalSpacing(8);
  row->setVerticalSpacing(4);
  constexpr double farthest = 1e9; // of any map
  for (int axis = 0; axis < 3; ++axis) {
    const QChar name("xyz"[axis]);
    auto& ends = ends_[static_cast<std::size_t>(axis)];
    row->addWidget(new QLabel(tr("%1 from").arg(name), sides_), axis, 0);
    for (int end = 0; end < 2; ++end) {
      auto* field = new NumberBox(sides_);
      field->setRange(-farthest, farthest);
      field->setObjectName(QStringLiteral("box_%1_%2").arg(name).arg(end == 0 ? "from" : "to"));
      field->setAccessibleName(end == 0 ? tr("%1 from").arg(name) : tr("%1 to").arg(name));
      connect(field, &QDoubleSpinBox::valueChanged, this, &PartForm::refresh);
      ends[static_cast<std::size_t>(end)] = field;
      row->addWidget(field, axis, 1 + 2 * end);
    }
    row->addWidget(new QLabel(tr("to"), sides_), axis, 2);
  }
  row->setColumnStretch(4, 1);
}

void PartForm::fillBox() {
  const Eigen::AlignedBox3d& bounds = glance_.bounds;
  if (bounds.isEmpty()) return;
  const int decimals = decimalsIn(bounds);
  const double step = std::pow(10.0, -decimals);
  for (int axis = 0; axis < 3; ++axis)
    for (int end = 0; end < 2; ++end) {
      QDoubleSpinBox* field = ends_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)];
      const QSignalBlocker blocker(field);
      field->setDecimals(decimals);
      field->setSingleStep(100 * step);
      field->setValue(end == 0 ? std::floor(bounds.min()[axis] / step) * step
                               : std::ceil(bounds.max()[axis] / step) * step);
      filled_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)] = field->value();
    }
}

void PartForm::setGlance(const PointGlance& glance) {
  const bool isOther = !glance.bounds.isApprox(glance_.bounds);
  glance_ = glance;
  if (isOther) fillBox();
  refresh();
}

bool PartForm::hasMoreBeyond() const {
  return glance_.areBoundsOfSample && !glance_.bounds.isEmpty();
}

/// A side that is left as it was filled in holds all beyond it, too, where points may reach farther
/// than those that were looked at.
Eigen::AlignedBox3d PartForm::box() const {
  constexpr double beyond = 100; // extents of the sample
  const double reach = hasMoreBeyond() ? beyond * glance_.bounds.sizes().maxCoeff() : 0;
  Eigen::AlignedBox3d box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto valueOf = [&](std::size_t end) {
      const double value = ends_[axis][end]->value();
      if (value != filled_[axis][end]) return value;
      return end == 0 ? value - reach : value + reach;
    };
    box.min()[static_cast<Eigen::Index>(axis)] = valueOf(0);
    box.max()[static_cast<Eigen::Index>(axis)] = valueOf(1);
  }
  return box;
}

void PartForm::choose(ReadOptions& options) const {
  options.most = some_->isChecked() ? static_cast<std::uint64_t>(most_->value()) : 0;
  if (isBoxed_->isChecked()) options.box = box();
}

void PartForm::show(const ReadOptions& options) {
  if (options.most > 0) most_->setCount(options.most);
  (options.most > 0 ? some_ : all_)->setChecked(true);
  isBoxed_->setChecked(options.box.has_value());
  if (!options.box) return;
  for (int axis = 0; axis < 3; ++axis) { // sides beyond what is filled in stay so
    const auto& ends = ends_[static_cast<std::size_t>(axis)];
    const auto& filled = filled_[static_cast<std::size_t>(axis)];
    const double from = options.box->min()[axis];
    const double to = options.box->max()[axis];
    ends[0]->setValue(hasMoreBeyond() ? std::max(from, filled[0]) : from);
    ends[1]->setValue(hasMoreBeyond() ? std::min(to, filled[1]) : to);
  }
}

QString PartForm::problem() const {
  if (isBoxed_->isChecked())
    for (int axis = 0; axis < 3; ++axis)
      if (!(box().min()[axis] < box().max()[axis]))
        return tr("The box is empty along %1: its second number is to be the larger one.")
            .arg(QChar("xyz"[axis]));
  return {};
}

void PartForm::refresh() {
  sides_->setVisible(isBoxed_->isChecked());
  const std::optional<std::uint64_t> inBox =
      isBoxed_->isChecked() ? pointsIn(box(), glance_) : glance_.points;
  const std::uint64_t there = inBox.value_or(glance_.points); // at most
  const auto most = static_cast<std::uint64_t>(most_->value());
  allText_->setText(tr("about %1 of memory").arg(memoryText(there)));
  someText_->setText(
      tr("from all over it, about %1 of memory").arg(memoryText(std::min(most, there))));
  boxText_->setText(!isBoxed_->isChecked() ? QString()
                    : inBox                ? tr("%1 points").arg(pointsText(there, true))
                                           : tr("their number is known once they are read"));
  emit changed();
}

} // namespace espalier
