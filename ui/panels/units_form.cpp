#include "ui/panels/units_form.h"

#include "core/mtg/unit_edits.h"
#include "core/mtg/unit_scales.h"
#include "ui/document/plant_document.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {
namespace {

QString nameOf(const Entity& entity) {
  return QString::fromStdString(entity.symbol) +
         (entity.index ? QString::number(*entity.index) : QString());
}

QString valueOf(const Entity& entity, const std::string& feature) {
  const auto found = std::ranges::find(entity.values, feature, &FeatureValue::feature);
  return found == entity.values.end() ? QString() : QString::fromStdString(found->text);
}

bool carriesAnything(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids(); // roots, which begin units, come first
  return std::ranges::any_of(ids, [&](NodeId id) { return !skeleton[id].entities.empty(); });
}

const Mtg* baseOf(const PlantDocument& document) {
  return document.structure().frame ? &document.structure().frame->mtg : nullptr;
}

} // namespace

UnitsForm::UnitsForm(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
}

void UnitsForm::show(NodeId id) {
  if (!carriesAnything(document_.skeleton())) {
    showNothing();
    return;
  }
  build(partsOf(id));
  setVisible(true);
}

void UnitsForm::showNothing() {
  setVisible(false);
  parts_.clear();
}

QList<UnitsForm::Part> UnitsForm::partsOf(NodeId id) const {
  const Skeleton& skeleton = document_.skeleton();
  QList<Part> parts = {partOf(id, ownEntity(skeleton, id), true)};
  std::vector<UnitPlace> units = unitsOf(skeleton, id);
  std::ranges::reverse(units);
  for (const UnitPlace& unit : units) {
    const Entity& entity = skeleton[unit.start].entities[unit.entity];
    Part part = partOf(unit.start, entity, false);
    part.canBegin = skeleton[id].parent.has_value();
    part.begins = unit.start == id;
    part.step = (part.begins ? tr("End %1 at node %2") : tr("Begin a unit like %1 at node %2"))
                    .arg(nameOf(entity))
                    .arg(indexOf(id));
    part.beginOrEnd = [id, scale = entity.scale, ends = part.begins](SkeletonEditor& editor) {
      (ends ? endUnit : beginUnit)(editor, id, scale);
    };
    parts.append(part);
  }
  return parts;
}

UnitsForm::Part UnitsForm::partOf(NodeId start, const Entity& entity, bool isNode) const {
  const Mtg* base = baseOf(document_);
  const int scale = entity.scale;
  const QString name = isNode ? tr("node %1").arg(indexOf(start)) : nameOf(entity);
  const QString end = QStringLiteral("_%1").arg(scale);
  Part part{.id = "unit" + end};
  part.title = isNode ? tr("As %1, scale %2").arg(nameOf(entity)).arg(scale)
                      : tr("In %1, scale %2").arg(nameOf(entity)).arg(scale);
  part.rows.append({"class" + end, tr("Class"), QString::fromStdString(entity.symbol),
                    tr("Letters alone"), tr("Set the class of %1").arg(name),
                    [=](SkeletonEditor& editor, const std::string& text) {
                      setClass(editor, start, scale, text, base);
                    }});
  part.rows.append({"index" + end, tr("Index"),
                    entity.index ? QString::number(*entity.index) : QString(),
                    tr("A whole number, or nothing"), tr("Set the index of %1").arg(name),
                    [=](SkeletonEditor& editor, const std::string& text) {
                      setIndex(editor, start, scale, text);
                    }});
  for (const MtgFeature& feature : typedFeatures(entity, isNode, base)) {
    const QString label = QString::fromStdString(feature.name);
    part.rows.append({"feature_" + label + end, label, valueOf(entity, feature.name),
                      tr("Of type %1").arg(QString::fromStdString(feature.type)),
                      tr("Set %1 of %2").arg(label, name),
                      [=](SkeletonEditor& editor, const std::string& text) {
                        setFeature(editor, start, scale, feature, text, base);
                      }});
  }
  return part;
}

/// Keeps the fields where the same ones are shown, so that Tab leads from one to the next.
void UnitsForm::build(const QList<Part>& parts) {
  ++shown_;
  parts_ = parts;
  QStringList shape;
  for (const Part& part : parts_) {
    shape.append(part.id + (part.canBegin ? "b" : ""));
    for (const Row& row : part.rows)
      shape.append(row.id);
  }
  if (shape != shape_ || body_ == nullptr) makeFields();
  shape_ = shape;
  for (const Part& part : parts_) {
    body_->findChild<QLabel*>("title_" + part.id)->setText(part.title);
    if (auto* begins = body_->findChild<QCheckBox*>("begins_" + part.id))
      begins->setChecked(part.begins);
    for (const Row& row : part.rows) {
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
    body_->deleteLater(); // one of its fields may be telling of an edit
  }
  body_ = new QWidget(this);
  auto* form = new QFormLayout(body_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(8);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows); // a long name must not widen the panel
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (const Part& part : parts_) {
    auto* title = new QLabel(body_);
    title->setObjectName("title_" + part.id);
    title->setProperty("role", "section");
    form->addRow(title);
    for (const Row& row : part.rows)
      addRow(row, *form);
    if (!part.canBegin) continue;
    auto* begins = new QCheckBox(tr("begins here"), body_);
    begins->setObjectName("begins_" + part.id);
    form->addRow(begins);
    connect(begins, &QCheckBox::clicked, this, [this, begins] { beginOrEnd(*begins); });
  }
  column_->addWidget(body_);
}

void UnitsForm::beginOrEnd(QCheckBox& begins) {
  const auto found = std::ranges::find_if(
      parts_, [&](const Part& part) { return begins.objectName() == "begins_" + part.id; });
  if (found == parts_.end()) return;
  const Part told = *found; // telling it replaces the parts
  const int shownBefore = shown_;
  emit typed(told.step, told.beginOrEnd, &begins);
  if (shown_ == shownBefore) begins.setChecked(told.begins); // it was refused
}

void UnitsForm::addRow(const Row& row, QFormLayout& to) {
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
  if (field.property("refused") == text) return false; // told already
  for (const Part& part : parts_)
    for (const Row& row : part.rows) {
      if (row.id != field.objectName() || row.text == text) continue;
      const Row told = row; // telling it replaces the rows
      field.setProperty("refused", text);
      const int shownBefore = shown_;
      emit typed(
          told.step,
          [change = told.change, typedText = text.toStdString()](SkeletonEditor& editor) {
            change(editor, typedText);
          },
          &field);
      return shown_ != shownBefore; // if it is taken, the fields are shown anew
    }
  return true;
}

} // namespace espalier
