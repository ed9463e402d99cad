#include "ui/panels/scan_form.h"

#include "ui/document/plant_document.h"
#include "ui/panels/focus_keys.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

namespace espalier {
namespace {

enum RootRow { lowest, pick, picked }; // of the list; the last only once it is

QString pointsText(const Scan& scan) {
  const auto all = static_cast<std::size_t>(scan.cloud()->size());
  const std::size_t aside = scan.leftOut().size();
  return aside == 0 ? formatCount(all)
                    : ScanForm::tr("%1 of %2").arg(formatCount(all - aside), formatCount(all));
}

} // namespace

ScanForm::ScanForm(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), name_(new QLabel(this)), points_(new QLabel(this)),
      size_(new QLabel(this)), unit_(new QComboBox(this)), up_(new QComboBox(this)),
      root_(new QComboBox(this)) {
  name_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  unit_->addItem(tr("not known"), QString());
  for (const LengthUnit unit : {LengthUnit::millimeter, LengthUnit::centimeter, LengthUnit::meter})
    unit_->addItem(symbol(unit), symbol(unit));
  opensOnEnter(*unit_);
  unit_->setObjectName("unit");
  unit_->setToolTip(tr("The unit of the coordinates. They are shown with it, never rescaled."));
  for (const char* axis : {"x", "y", "z"}) // in the order of UpAxis
    up_->addItem(QString::fromLatin1(axis));
  opensOnEnter(*up_);
  up_->setObjectName("up");
  up_->setToolTip(tr("The axis of the file that points up, from the foot of the plant to its top"));
  root_->addItem(tr("lowest point"));
  root_->addItem(tr("pick in the view…"));
  opensOnEnter(*root_);
  root_->setObjectName("root");
  root_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  root_->setToolTip(tr("Where the plant begins: the foot of its trunk"));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(4);
  form->setLabelAlignment(Qt::AlignLeft);
  form->addRow(tr("Scan"), name_);
  points_->setObjectName("scan_points");
  size_->setObjectName("scan_size");
  form->addRow(tr("Points"), points_);
  form->addRow(tr("Size"), size_);
  for (QComboBox* choice : {unit_, up_}) // they widen no panel
    choice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* side = new QHBoxLayout; // by side: steps need the height
  side->setSpacing(8);
  side->addWidget(unit_, 3);
  unit_->setAccessibleName(tr("Unit")); // whose label is that of both
  auto* up = new QLabel(tr("Up"));
  up->setBuddy(up_);
  side->addWidget(up);
  side->addWidget(up_, 2);
  form->addRow(tr("Unit"), side);
  form->addRow(tr("Root"), root_);
  connect(unit_, &QComboBox::activated, this,
          [this] { document_.setUnit(unitOfSymbol(unit_->currentData().toString())); });
  connect(up_, &QComboBox::activated, this,
          [this](int axis) { document_.setUp(static_cast<UpAxis>(axis)); });
  connect(root_, &QComboBox::activated, this, &ScanForm::chooseRoot);
  for (auto signal :
       {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged, &PlantDocument::unitChanged,
        &PlantDocument::upChanged, &PlantDocument::rootChanged})
    connect(&document_, signal, this, &ScanForm::refresh);
  connect(&document_, &PlantDocument::skeletonReplaced, this, &ScanForm::refreshUp);
  connect(&document_, &PlantDocument::skeletonEdited, this, &ScanForm::refreshUp);
  refresh();
}

void ScanForm::refresh() {
  unit_->setCurrentIndex(unit_->findData(symbol(document_.unit())));
  refreshUp();
  refreshRoot();
  const Scan* scan = document_.scan();
  root_->setEnabled(scan != nullptr);
  const QString none = QStringLiteral("–");
  name_->setText(scan ? QFileInfo(document_.scanPath()).fileName() : none);
  name_->setToolTip(document_.scanPath());
  points_->setText(scan ? pointsText(*scan) : none);
  if (!scan) {
    size_->setText(none);
    return;
  }
  const Eigen::Vector3d sides = scan->bounds().sizes();
  const auto side = [&](int axis) { return formatLength(sides[axis], LengthUnit::unknown, 3); };
  size_->setText(
      QStringLiteral("%1×%2×%3").arg(side(0), side(1), side(2)) +
      (document_.unit() == LengthUnit::unknown ? QString() : " " + symbol(document_.unit())));
}

/// Traits and views follow it without a scan, too.
void ScanForm::refreshUp() {
  up_->setCurrentIndex(static_cast<int>(document_.up()));
  up_->setEnabled(!document_.isEmpty());
}

void ScanForm::refreshRoot() {
  const std::optional<Eigen::Vector3d>& root = document_.root();
  if (root_->count() > picked) root_->removeItem(picked);
  if (root) {
    QStringList at;
    for (const double coordinate : *root)
      at.append(formatLength(coordinate, LengthUnit::unknown, 3));
    root_->addItem(tr("at %1").arg(at.join(QStringLiteral(", "))));
  }
  root_->setCurrentIndex(root ? picked : lowest);
}

void ScanForm::chooseRoot() {
  const int row = root_->currentIndex();
  refreshRoot(); // until one is picked, it is what it was
  if (row == lowest) document_.setRoot(std::nullopt);
  if (row == pick) emit rootAsked();
}

} // namespace espalier
