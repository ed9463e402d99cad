#include "ui/dialogs/add_value_dialog.h"

#include "core/mtg/typed_values.h"
#include "ui/document/manual_place.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace espalier {
namespace {

QString describe(std::string_view type) {
  const QString name = QString::fromUtf8(type.data(), qsizetype(type.size()));
  if (type == "REAL") return AddValueDialog::tr("Number (REAL)");
  if (type == "INT") return AddValueDialog::tr("Whole number (INT)");
  if (type == "ALPHA" || type == "STRING") return AddValueDialog::tr("Text (%1)").arg(name);
  return AddValueDialog::tr("Date (%1)").arg(name);
}

} // namespace

AddValueDialog::AddValueDialog(const QString& title, std::vector<MtgFeature> known, QWidget* parent)
    : QDialog(parent), known_(std::move(known)), name_(new QLineEdit(this)),
      type_(new QComboBox(this)), value_(new QLineEdit(this)) {
  setObjectName("add_value");
  setManualPlace(*this, QStringLiteral("correct.md#scales-by-hand"));
  setWindowTitle(title);
  setMinimumWidth(320);
  name_->setObjectName("feature_name");
  name_->setPlaceholderText(tr("such as Length or leaf_area"));
  name_->setVisible(known_.empty());
  type_->setObjectName("feature_type");
  value_->setObjectName("feature_value");
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(8);
  if (known_.empty()) form->addRow(tr("Feature"), name_);
  form->addRow(known_.empty() ? tr("Kind") : tr("Feature"), type_);
  form->addRow(tr("Value"), value_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  add_ = buttons->addButton(tr("Add"), QDialogButtonBox::AcceptRole);
  add_->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addLayout(form);
  column->addWidget(buttons);
  if (known_.empty())
    addTypes();
  else
    addKnown();
  connect(name_, &QLineEdit::textChanged, this, &AddValueDialog::refresh);
  connect(value_, &QLineEdit::textChanged, this, &AddValueDialog::refresh);
  connect(type_, &QComboBox::currentIndexChanged, this, &AddValueDialog::refresh);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    emit addRequested({feature(), value_->text().toStdString()});
  });
  refresh();
}

QWidget* AddValueDialog::nameField() const {
  return name_;
}

QWidget* AddValueDialog::valueField() const {
  return value_;
}

void AddValueDialog::addTypes() {
  for (const std::string_view type : featureTypes())
    type_->addItem(describe(type), QString::fromUtf8(type.data(), qsizetype(type.size())));
}

/// Of a later date one mostly types the date first.
void AddValueDialog::addKnown() {
  for (const MtgFeature& each : known_) {
    const QString type = QString::fromStdString(each.type);
    type_->addItem(tr("%1 (%2)").arg(QString::fromStdString(each.name), type), type);
    if (type.contains("DD/MM") && !type_->currentData().toString().contains("DD/MM"))
      type_->setCurrentIndex(type_->count() - 1);
  }
}

MtgFeature AddValueDialog::feature() const {
  if (!known_.empty()) return known_[std::size_t(type_->currentIndex())];
  return {name_->text().toStdString(), type_->currentData().toString().toStdString()};
}

void AddValueDialog::refresh() {
  const std::string type = type_->currentData().toString().toStdString();
  value_->setPlaceholderText(tr("such as %1").arg(QString::fromStdString(exampleOf(type))));
  const bool isNamed = !known_.empty() || !name_->text().trimmed().isEmpty();
  add_->setEnabled(isNamed && !value_->text().trimmed().isEmpty());
}

} // namespace espalier
