#include "ui/panels/units_form.h"

#include "ui/document/plant_document.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {
UnitsForm::UnitsForm(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
}

void UnitsForm::show(NodeId id) {
  build(unitParts(document_, id));
  setVisible(true);
}

void UnitsForm::showNothing() {
  setVisible(false);
  parts_.clear();
}

/// Keeps the fields where the same ones are shown, so that Tab leads from one to the next.
void UnitsForm::build(const QList<UnitPart>& parts) {
  ++shown_;
  parts_ = parts;
  QStringList shape;
  for (const UnitPart& part : parts_) {
    shape.append(part.id + (part.canBegin ? "b" : "") + (part.canDate ? "d" : ""));
    for (const UnitRow& row : part.rows)
      shape.append(row.id + (row.heading.isEmpty() ? "" : "h"));
  }
  if (shape != shape_ || body_ == nullptr) makeFields();
  shape_ = shape;
  for (const UnitPart& part : parts_) {
    body_->findChild<QLabel*>("title_" + part.id)->setText(part.title);
    if (auto* begins = body_->findChild<QCheckBox*>("begins_" + part.id))
      begins->setChecked(part.begins);
    for (const UnitRow& row : part.rows) {
      if (auto* heading = body_->findChild<QLabel*>("heading_" + row.id))
        heading->setText(row.heading);
      auto* field = body_->findChild<QLineEdit*>(row.id);
      field->setText(row.text);
      field->setCursorPosition(0);
      field->setProperty("refused", {});
    }
  }
}

void UnitsForm::makeFields() {
  if (body_ != nullptr) {
    for (QWidget* field : body_->findChildren<QWidget*>()) {
      field->blockSignals(true); // hiding a field that has the focus ends its text
      field->setObjectName({});
    }
    body_->hide();
    body_->deleteLater(); // one of its fields may be reporting an edit
  }
  body_ = new QWidget(this);
  auto* form = new QFormLayout(body_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(8);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows); // a long name must not widen the panel
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (const UnitPart& part : parts_) {
    auto* title = new QLabel(body_);
    title->setObjectName("title_" + part.id);
    title->setProperty("role", "section");
    form->addRow(title);
    for (const UnitRow& row : part.rows)
      addRow(row, *form);
    addButtons(part, *form);
    if (!part.canBegin) continue;
    auto* begins = new QCheckBox(tr("begins here"), body_);
    begins->setObjectName("begins_" + part.id);
    form->addRow(begins);
    connect(begins, &QCheckBox::clicked, this, [this, begins] { beginOrEnd(*begins); });
  }
  column_->addWidget(body_);
}

/// What is added to a node or unit; on Enter and click alone, so that Tab passes by.
void UnitsForm::addButtons(const UnitPart& part, QFormLayout& to) {
  auto* column = new QVBoxLayout; // side by side they would widen the panel
  column->setSpacing(4);
  const auto add = [&](const QString& name, const QString& text, const QString& help, bool isDate) {
    auto* button = new QPushButton(text, body_);
    button->setObjectName(name + "_" + part.id);
    button->setToolTip(help);
    button->setFlat(true);
    button->setProperty("role", "link");
    button->setCursor(Qt::PointingHandCursor);
    column->addWidget(button, 0, Qt::AlignLeft);
    connect(button, &QPushButton::clicked, this,
            [this, id = part.id, isDate] { requestValue(id, isDate); });
  };
  add("add_feature", tr("Add feature…"), tr("Declares a feature that the file does not have yet"),
      false);
  if (part.canDate) add("add_date", tr("Add date…"), tr("Adds values of a later date"), true);
  to.addRow(column);
}

void UnitsForm::requestValue(const QString& partId, bool isDate) {
  const auto found = std::ranges::find(parts_, partId, &UnitPart::id);
  if (found == parts_.end()) return;
  const UnitPart part = *found; // an answer replaces the parts
  if (isDate)
    emit dateRequested(part);
  else
    emit featureRequested(part);
}

void UnitsForm::beginOrEnd(QCheckBox& begins) {
  const auto found = std::ranges::find_if(
      parts_, [&](const UnitPart& part) { return begins.objectName() == "begins_" + part.id; });
  if (found == parts_.end()) return;
  const UnitPart edited = *found; // reporting it replaces the parts
  const int shownBefore = shown_;
  emit typed(edited.step, edited.beginOrEnd, &begins);
  if (shown_ == shownBefore) begins.setChecked(edited.begins); // it was refused
}

void UnitsForm::addRow(const UnitRow& row, QFormLayout& to) {
  if (!row.heading.isEmpty()) {
    auto* heading = new QLabel(body_);
    heading->setObjectName("heading_" + row.id);
    heading->setProperty("role", "quiet");
    to.addRow(heading);
  }
  auto* field = new QLineEdit(body_);
  field->setObjectName(row.id);
  field->setToolTip(row.help);
  field->setMinimumWidth(72);
  field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  to.addRow(row.label, field);
  connect(field, &QLineEdit::editingFinished, this, [this, field] { take(*field); });
  connect(field, &QLineEdit::returnPressed, this, [this, field] {
    field->setProperty("refused", {}); // Enter asks again
    if (take(*field)) emit leaveRequested();
  });
}

/// @return whether it stands now
bool UnitsForm::take(QLineEdit& field) {
  const QString text = field.text();
  if (field.property("refused") == text) return false; // reported already
  for (const UnitPart& part : parts_)
    for (const UnitRow& row : part.rows) {
      if (row.id != field.objectName() || row.text == text) continue;
      const UnitRow edited = row; // reporting it replaces the rows
      field.setProperty("refused", text);
      const int shownBefore = shown_;
      emit typed(
          edited.step,
          [change = edited.change, typedText = text.toStdString()](SkeletonEditor& editor) {
            change(editor, typedText);
          },
          &field);
      return shown_ != shownBefore; // if it is taken, the fields are shown anew
    }
  return true;
}

} // namespace espalier
