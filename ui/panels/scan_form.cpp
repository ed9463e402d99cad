#include "ui/panels/scan_form.h"

#include "ui/document/plant_document.h"
#include "ui/panels/focus_keys.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>

namespace espalier {

ScanForm::ScanForm(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), name_(new QLabel(this)), points_(new QLabel(this)),
      size_(new QLabel(this)), unit_(new QComboBox(this)) {
  name_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  unit_->addItem(tr("not known"), QString());
  for (const LengthUnit unit : {LengthUnit::millimeter, LengthUnit::centimeter, LengthUnit::meter})
    unit_->addItem(symbol(unit), symbol(unit));
  opensOnEnter(*unit_);
  unit_->setObjectName("unit");
  unit_->setToolTip(tr("The unit of the coordinates. They are shown with it, never rescaled."));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(4);
  form->setLabelAlignment(Qt::AlignLeft);
  form->addRow(tr("Scan"), name_);
  form->addRow(tr("Points"), points_);
  form->addRow(tr("Size"), size_);
  form->addRow(tr("Unit"), unit_);
  connect(unit_, &QComboBox::activated, this,
          [this] { document_.setUnit(unitOfSymbol(unit_->currentData().toString())); });
  connect(&document_, &PlantDocument::scanChanged, this, &ScanForm::refresh);
  connect(&document_, &PlantDocument::unitChanged, this, &ScanForm::refresh);
  refresh();
}

void ScanForm::refresh() {
  unit_->setCurrentIndex(unit_->findData(symbol(document_.unit())));
  const Scan* scan = document_.scan();
  const QString none = QStringLiteral("–");
  name_->setText(scan ? QFileInfo(document_.scanPath()).fileName() : none);
  name_->setToolTip(document_.scanPath());
  points_->setText(scan ? formatCount(std::size_t(scan->cloud()->size())) : none);
  if (!scan) {
    size_->setText(none);
    return;
  }
  const Eigen::Vector3d sides = scan->cloud()->bounds().sizes();
  const auto side = [&](int axis) { return formatLength(sides[axis], LengthUnit::unknown, 3); };
  size_->setText(
      QStringLiteral("%1×%2×%3").arg(side(0), side(1), side(2)) +
      (document_.unit() == LengthUnit::unknown ? QString() : " " + symbol(document_.unit())));
}

} // namespace espalier
