#include "ui/panels/word_fields.h"

#include "ui/document/shown_text.h"
#include "ui/panels/focus_keys.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace espalier {

ChoiceField::ChoiceField(const Option& option, QGridLayout& grid, QWidget& parent)
    : OptionField(option, parent), words_(new QComboBox(&parent)) {
  words_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  words_->setMinimumContentsLength(8);
  opensOnEnter(*words_);
  words_->setObjectName(QString::fromStdString(option.name));
  words_->setAccessibleName(label().text());
  for (const Choice& choice : option.choices)
    words_->addItem(shownText(choice.label));
  label().setBuddy(words_);
  const int row = grid.rowCount();
  addHead(grid, row, label());
  grid.addWidget(words_, row + 1, 0, 1, 2);
  connect(words_, &QComboBox::activated, this, [this](int index) { choose(index); });
}

void ChoiceField::showScale(const QString& /*unit*/) {
  words_->setToolTip(help());
}

void ChoiceField::showValue() {
  words_->setCurrentIndex(static_cast<int>(value()));
}

FlagField::FlagField(const Option& option, QGridLayout& grid, QWidget& parent)
    : OptionField(option, parent), box_(new QCheckBox(label().text(), &parent)) {
  box_->setObjectName(QString::fromStdString(option.name));
  label().hide(); // the box says it
  addHead(grid, grid.rowCount(), *box_);
  connect(box_, &QCheckBox::clicked, this, [this](bool isOn) { choose(isOn ? 1 : 0); });
}

void FlagField::showScale(const QString& /*unit*/) {
  box_->setToolTip(help());
}

void FlagField::showValue() {
  box_->setChecked(value() != 0);
}

} // namespace espalier
