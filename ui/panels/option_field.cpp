#include "ui/panels/option_field.h"

#include "ui/document/shown_text.h"
#include "ui/panels/label_role.h"
#include "ui/panels/number_field.h"
#include "ui/panels/word_fields.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace espalier {

OptionField* OptionField::make(const Option& option, QGridLayout& grid, QWidget& parent) {
  OptionField* field = nullptr;
  if (option.kind == OptionKind::choice)
    field = new ChoiceField(option, grid, parent);
  else if (option.kind == OptionKind::flag)
    field = new FlagField(option, grid, parent);
  else
    field = new NumberField(option, grid, parent);
  field->setScale(field->scale_, {});
  return field;
}

OptionField::OptionField(const Option& option, QWidget& parent)
    : QObject(&parent), option_(option), label_(new QLabel(shownText(option.label), &parent)),
      reset_(new QToolButton(&parent)) {
  reset_->setText(QStringLiteral("↺"));
  reset_->setAutoRaise(true);
  reset_->setFixedSize(20, 20);
  reset_->setAccessibleName(tr("Back to the default"));
  QSizePolicy keepsPlace = reset_->sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true); // so that columns do not jump
  reset_->setSizePolicy(keepsPlace);
  connect(reset_, &QToolButton::clicked, this, [this] { choose(std::nullopt); });
}

void OptionField::addHead(QGridLayout& grid, int row, QWidget& text) const {
  auto* head = new QHBoxLayout;
  head->setSpacing(4);
  head->addWidget(&text, 1);
  head->addWidget(reset_);
  grid.addLayout(head, row, 0, 1, 2);
}

void OptionField::setScale(const PlantScale& scale, const QString& unit) {
  scale_ = scale;
  label_->setToolTip(help());
  showScale(unit);
  show();
}

void OptionField::choose(const std::optional<Rule>& value) {
  chosen_ = value;
  show();
  emit changed();
}

QString OptionField::help() const {
  return tr("<qt>%1<br>Default: %2</qt>") // rich, so that it is broken into lines
      .arg(shownText(option_.help).toHtmlEscaped(),
           QString::fromStdString(option_.ruleText()).toHtmlEscaped());
}

void OptionField::show() {
  showValue();
  const std::optional<QString> needed = allowed();
  const QString name = shownText(option_.label);
  label_->setText(needed ? tr("%1: %2").arg(name, *needed) : name);
  setRole(*label_, needed ? "warning" : "");
  reset_->setVisible(chosen_.has_value());
  const bool isRule = chosen_ && !chosen_->isFixed(); // the field shows what it is for this plant
  reset_->setToolTip(
      isRule ? tr("Set to %1: back to the default").arg(QString::fromStdString(chosen_->text()))
             : tr("Back to the default"));
}

} // namespace espalier
