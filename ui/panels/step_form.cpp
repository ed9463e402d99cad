#include "ui/panels/step_form.h"

#include "ui/document/shown_text.h"
#include "ui/panels/density_curve.h"
#include "ui/panels/density_fields.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/option_field.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace espalier {

StepForm::StepForm(const Step& step, int number, QWidget* parent)
    : QWidget(parent), step_(step), header_(new QToolButton(this)), note_(new QLabel(this)),
      state_(new QLabel(this)), run_(new QToolButton(this)), body_(new QWidget(this)),
      column_(new QVBoxLayout(body_)), method_(new QComboBox(body_)) {
  setObjectName("step_" + QString::fromStdString(step.name));
  header_->setText(QStringLiteral("%1  %2").arg(number).arg(shownText(step.label)));
  header_->setToolTip(shownText(step.help));
  header_->setProperty("role", "step");
  header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header_->setCheckable(true);
  header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  note_->setProperty("role", "quiet");
  note_->setAttribute(Qt::WA_TransparentForMouseEvents);
  state_->setProperty("role", "state");
  state_->setAttribute(Qt::WA_TransparentForMouseEvents);
  run_->setObjectName("run_to_" + QString::fromStdString(step.name));
  run_->setText(QStringLiteral("▸"));
  run_->setProperty("role", "quiet");
  run_->setAutoRaise(true);
  run_->setToolTip(tr("Runs the steps up to this one, those that are not up to date"));
  run_->setAccessibleName(tr("Run up to %1").arg(shownText(step.label)));
  connect(run_, &QToolButton::clicked, this, &StepForm::runRequested);
  for (const Method& method : step.methods) {
    method_->addItem(shownText(method.label), QString::fromStdString(method.name));
    method_->setItemData(method_->count() - 1, shownText(method.help), Qt::ToolTipRole);
  }
  method_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  method_->setMinimumContentsLength(8); // long names are cut off rather than widen the form
  method_->setVisible(step.methods.size() > 1);
  opensOnEnter(*method_);
  method_->setAccessibleName(tr("Method of %1").arg(shownText(step.label)));
  column_->setContentsMargins(28, 4, 12, 12);
  column_->setSpacing(8);
  column_->addWidget(method_);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(0);
  grid->addWidget(header_, 0, 0, 1, 3);
  grid->addWidget(note_, 0, 1, Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(state_, 0, 2, Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(run_, 0, 3);
  grid->setColumnStretch(0, 1);
  grid->addWidget(body_, 1, 0, 1, 4);
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
  if (curveFields_ != nullptr) curveFields_->setScale(scale, unit);
}

void StepForm::setDensities(std::vector<float> densities) {
  densities_ = std::move(densities);
  if (curve_ != nullptr) curve_->setDensities(densities_);
}

void StepForm::setState(State state, const QString& note, const QString& details) {
  struct Look {
    QString sign;
    QString name;
  };
  const Look shown = [&]() -> Look {
    switch (state) {
    case State::stale:
      return {QStringLiteral("○"), tr("to be run again")};
    case State::running:
      return {QStringLiteral("●"), tr("running")};
    case State::done:
      return {QStringLiteral("✓"), tr("up to date")};
    case State::failed:
      return {QStringLiteral("✕"), tr("failed")};
    case State::idle:
      break;
    }
    return {};
  }();
  current_ = state;
  note_->setText(note);
  state_->setText(shown.sign);
  state_->setAccessibleName(shown.name);
  header_->setAccessibleDescription(shown.name);
  const QString help = shownText(step_.help);
  const QString stateLine = details.isEmpty() ? shown.name : details;
  header_->setToolTip(stateLine.isEmpty() ? help : help + QStringLiteral("\n") + stateLine);
}

void StepForm::setRunnable(bool isRunnable) {
  run_->setEnabled(isRunnable);
}

void StepForm::setOpen(bool isOpen) {
  header_->setChecked(isOpen);
  header_->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
  body_->setVisible(isOpen);
  if (isOpen) emit opened();
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
  curve_ = nullptr;
  curveFields_ = nullptr;
  options_ = new QWidget(body_);
  auto* grid = new QGridLayout(options_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(0, 1);
  const Method& method = step_.methods[static_cast<std::size_t>(method_->currentIndex())];
  auto* help = new QLabel(shownText(method.help), options_);
  help->setWordWrap(true);
  help->setProperty("role", "quiet");
  if (!method.source.empty()) help->setToolTip(tr("Source: %1").arg(method.source.c_str()));
  grid->addWidget(help, 0, 0, 1, 2);
  const std::vector<Option>& options = method.options;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (i + 2 < options.size() && options[i + 2].kind == OptionKind::curve) addCurve(*grid);
    addField(options[i], *grid);
    if (options[i].kind == OptionKind::curve) tieCurve();
  }
  column_->addWidget(options_);
}

void StepForm::addField(const Option& option, QGridLayout& grid) {
  fields_.push_back(OptionField::make(option, grid, *options_));
  fields_.back()->setScale(scale_, unit_);
  connect(fields_.back(), &OptionField::changed, this, &StepForm::changed);
}

void StepForm::addCurve(QGridLayout& grid) {
  curve_ = new DensityCurve(options_);
  curve_->setDensities(densities_);
  grid.addWidget(curve_, grid.rowCount(), 0, 1, 2);
}

/// The last field is that of the exponent, those before it of the two ends.
void StepForm::tieCurve() {
  const auto exponent = fields_.end() - 1;
  curveFields_ = new DensityFields(*curve_, **(exponent - 2), **(exponent - 1), **exponent);
  curveFields_->setScale(scale_, unit_);
}

} // namespace espalier
