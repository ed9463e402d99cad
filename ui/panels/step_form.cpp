#include "ui/panels/step_form.h"

#include "ui/panels/option_field.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

StepForm::StepForm(const Step& step, int number, QWidget* parent)
    : QWidget(parent), step_(step), header_(new QToolButton(this)), state_(new QLabel(this)),
      body_(new QWidget(this)), column_(new QVBoxLayout(body_)), method_(new QComboBox(body_)) {
  setObjectName("step_" + QString::fromStdString(step.name));
  header_->setText(QStringLiteral("%1  %2").arg(number).arg(QString::fromStdString(step.label)));
  header_->setToolTip(QString::fromStdString(step.help));
  header_->setProperty("role", "step");
  header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header_->setCheckable(true);
  header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  state_->setProperty("role", "state");
  state_->setAttribute(Qt::WA_TransparentForMouseEvents);
  for (const Method& method : step.methods) {
    method_->addItem(QString::fromStdString(method.label), QString::fromStdString(method.name));
    method_->setItemData(method_->count() - 1, QString::fromStdString(method.help),
                         Qt::ToolTipRole);
  }
  method_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  method_->setMinimumContentsLength(8); // long names are cut off rather than widen the form
  method_->setVisible(step.methods.size() > 1);
  method_->setAccessibleName(tr("Method of %1").arg(QString::fromStdString(step.label)));
  column_->setContentsMargins(28, 4, 12, 12);
  column_->setSpacing(8);
  column_->addWidget(method_);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(0);
  grid->addWidget(header_, 0, 0, 1, 2);
  grid->addWidget(state_, 0, 1, Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(body_, 1, 0, 1, 2);
  connect(header_, &QToolButton::toggled, this, &StepForm::setOpen);
  connect(method_, &QComboBox::activated, this, [this] {
    showMethod();
    emit changed();
  });
  showMethod();
  setOpen(false);
}

void StepForm::setScale(const PlantScale& scale, const QString& unit) {
  scale_ = scale;
  unit_ = unit;
  for (OptionField* field : fields_)
    field->setScale(scale, unit);
}

void StepForm::setState(State state) {
  state_->setText(state == State::done ? QStringLiteral("✓")
                                       : (state == State::running ? QStringLiteral("●") : ""));
  state_->setAccessibleName(state == State::done      ? tr("done")
                            : state == State::running ? tr("running")
                                                      : QString());
}

void StepForm::setOpen(bool isOpen) {
  header_->setChecked(isOpen);
  header_->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
  body_->setVisible(isOpen);
}

void StepForm::addTo(PipelineOptions& options) const {
  const auto index = static_cast<std::size_t>(method_->currentIndex());
  const Method& method = step_.methods[index];
  if (index != 0) options.methods[step_.name] = method.name;
  for (std::size_t i = 0; i < fields_.size(); ++i)
    if (fields_[i]->chosen())
      options.settings[step_.name][method.options[i].name] = *fields_[i]->chosen();
}

void StepForm::choose(const PipelineOptions& options) {
  const auto method = options.methods.find(step_.name);
  const int index = method == options.methods.end()
                        ? 0
                        : method_->findData(QString::fromStdString(method->second));
  method_->setCurrentIndex(std::max(index, 0));
  showMethod();
  const auto settings = options.settings.find(step_.name);
  if (settings == options.settings.end()) return;
  const QSignalBlocker quiet(this);
  const auto& described = step_.methods[static_cast<std::size_t>(method_->currentIndex())].options;
  for (std::size_t i = 0; i < fields_.size(); ++i)
    if (const auto value = settings->second.find(described[i].name);
        value != settings->second.end())
      fields_[i]->choose(value->second);
}

void StepForm::showMethod() {
  delete options_;
  fields_.clear();
  options_ = new QWidget(body_);
  auto* grid = new QGridLayout(options_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(0, 1);
  const Method& method = step_.methods[static_cast<std::size_t>(method_->currentIndex())];
  auto* help = new QLabel(QString::fromStdString(method.help), options_);
  help->setWordWrap(true);
  help->setProperty("role", "quiet");
  if (!method.source.empty()) help->setToolTip(tr("Source: %1").arg(method.source.c_str()));
  grid->addWidget(help, 0, 0, 1, 2);
  for (const Option& option : method.options) {
    fields_.push_back(OptionField::make(option, *grid, *options_));
    fields_.back()->setScale(scale_, unit_);
    connect(fields_.back(), &OptionField::changed, this, &StepForm::changed);
  }
  column_->addWidget(options_);
}

} // namespace espalier
