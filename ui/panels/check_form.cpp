#include "ui/panels/check_form.h"

#include "core/pipeline/check_table.h"
#include "ui/panels/option_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

namespace espalier {

CheckForm::CheckForm(QWidget* parent)
    : QWidget(parent), header_(new QToolButton), body_(new QScrollArea) {
  setObjectName("check_form");
  header_->setObjectName("check_form_header");
  header_->setProperty("role", "step");
  header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  header_->setCheckable(true);
  header_->setToolTip(tr("From where on the checks report something"));
  auto* form = new QWidget;
  auto* grid = new QGridLayout(form);
  grid->setContentsMargins(0, 0, 8, 0);
  for (const Option& option : checkTable().descriptions()) {
    fields_.push_back(OptionField::make(option, *grid, *form));
    fields_.back()->setScale({.spacing = 1, .height = 1}, {}); // none of them is a length
    connect(fields_.back(), &OptionField::changed, this, [this] {
      refreshHeader();
      emit changed();
    });
  }
  grid->setColumnStretch(0, 1);
  for (QLabel* label : form->findChildren<QLabel*>())
    label->setWordWrap(true); // panels are narrow
  body_->setObjectName("check_form_body");
  body_->setWidget(form);
  body_->setWidgetResizable(true);
  body_->setFrameShape(QFrame::NoFrame);
  body_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(header_);
  column->addWidget(body_, 1);
  connect(header_, &QToolButton::toggled, this, &CheckForm::setOpen);
  setOpen(false);
}

CheckOptions CheckForm::options() const {
  std::vector<double> values;
  values.reserve(fields_.size());
  for (const OptionField* field : fields_)
    values.push_back(field->value());
  return checkTable().with(values);
}

std::map<std::string, double> CheckForm::chosen() const {
  std::map<std::string, double> result;
  for (const OptionField* field : fields_)
    if (field->chosen()) result[field->option().name] = field->value();
  return result;
}

void CheckForm::choose(const std::map<std::string, double>& chosen) {
  for (OptionField* field : fields_) {
    const QSignalBlocker blocker(field);
    const auto [least, most] = field->option().range({.spacing = 1, .height = 1});
    const auto found = chosen.find(field->option().name);
    field->choose(found != chosen.end()
                      ? std::optional(fixedAt(std::clamp(found->second, least, most)))
                      : std::nullopt);
  }
  refreshHeader();
}

void CheckForm::setOpen(bool isOpen) {
  header_->setChecked(isOpen);
  body_->setVisible(isOpen);
  setSizePolicy(QSizePolicy::Preferred, isOpen ? QSizePolicy::Expanding : QSizePolicy::Maximum);
  refreshHeader();
  emit opened(isOpen);
}

bool CheckForm::isOpen() const {
  return header_->isChecked();
}

void CheckForm::refreshHeader() {
  const std::size_t count = chosen().size();
  header_->setArrowType(isOpen() ? Qt::DownArrow : Qt::RightArrow);
  header_->setText(count == 0 ? tr("Limits of the checks")
                              : tr("Limits of the checks (%1 set)").arg(count));
}

} // namespace espalier
