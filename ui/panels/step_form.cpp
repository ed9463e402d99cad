#include "ui/panels/step_form.h"

#include "ui/document/shown_text.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/method_form.h"
#include "ui/panels/option_field.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace espalier {

StepForm::StepForm(const Step& step, int number, QWidget* parent)
    : QWidget(parent), step_(step), header_(new QToolButton(this)), count_(new QLabel(this)),
      note_(new QLabel(this)), state_(new QLabel(this)), run_(new QToolButton(this)),
      body_(new QWidget(this)), column_(new QVBoxLayout(body_)), method_(new QComboBox(body_)) {
  setObjectName("step_" + QString::fromStdString(step.name));
  header_->setText(number == 0 ? shownText(step.label)
                               : QStringLiteral("%1  %2").arg(number).arg(shownText(step.label)));
  header_->setToolTip(shownText(step.help));
  header_->setProperty("role", "step");
  header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header_->setCheckable(true);
  header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  count_->setObjectName("set_of_" + QString::fromStdString(step.name));
  count_->setProperty("role", "quiet");
  count_->setContentsMargins(0, 0, 8, 0);
  count_->setAttribute(Qt::WA_TransparentForMouseEvents);
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
  grid->addWidget(header_, 0, 0, 1, 4);
  grid->addWidget(count_, 0, 1, Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(note_, 0, 2, Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(state_, 0, 3, Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(run_, 0, 4);
  grid->setColumnStretch(0, 1);
  grid->addWidget(body_, 1, 0, 1, 5);
  connect(header_, &QToolButton::toggled, this, &StepForm::setOpen);
  connect(method_, &QComboBox::activated, this, &StepForm::takeMethod);
  connect(this, &StepForm::changed, this, &StepForm::showCount);
  showMethod();
  setOpen(false);
}

void StepForm::setScale(const PlantScale& scale, const QString& unit) {
  scale_ = scale;
  unit_ = unit;
  form_->setScale(scale, unit);
}

void StepForm::setDensities(std::vector<float> densities) {
  densities_ = std::move(densities);
  form_->setDensities(densities_);
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
  setRole(*state_, state == State::failed ? "failed" : "state");
  state_->setAccessibleName(shown.name);
  header_->setAccessibleDescription(shown.name);
  stateTip_ = details.isEmpty() ? shown.name : details;
  showTip();
}

void StepForm::showTip() {
  QStringList lines = {shownText(step_.help), count_->accessibleName(), stateTip_};
  lines.removeAll(QString());
  header_->setToolTip(lines.join('\n'));
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

StepForm::Settings StepForm::chosenSettings() const {
  Settings settings;
  for (const OptionField* field : form_->fields())
    if (field->chosen()) settings[field->option().name] = *field->chosen();
  return settings;
}

void StepForm::addTo(PipelineOptions& options) const {
  if (method_->currentIndex() != 0) options.methods[step_.name] = form_->method().name;
  if (const Settings settings = chosenSettings(); !settings.empty())
    options.settings[step_.name] = settings;
}

void StepForm::choose(const PipelineOptions& options) {
  before_.clear();
  const auto method = options.methods.find(step_.name);
  const int index = method == options.methods.end()
                        ? 0
                        : method_->findData(QString::fromStdString(method->second));
  method_->setCurrentIndex(std::max(index, 0));
  // Made anew only for another method: what Qt keeps of styled fields outlives them.
  if (&form_->method() != &chosenMethod()) showMethod();
  const auto settings = options.settings.find(step_.name);
  setFields(settings == options.settings.end() ? Settings() : settings->second);
}

/// Notifies nobody.
void StepForm::setFields(const Settings& settings) {
  const QSignalBlocker quiet(this);
  for (OptionField* field : form_->fields()) {
    const auto value = settings.find(field->option().name);
    field->choose(value == settings.end() ? std::nullopt : std::optional(value->second));
  }
  showCount();
}

void StepForm::takeMethod() {
  if (&form_->method() == &chosenMethod()) return;
  before_[&form_->method()] = chosenSettings();
  showMethod();
  setFields(before_[&chosenMethod()]);
  emit changed();
}

void StepForm::showCount() {
  const std::size_t count = chosenSettings().size() + (method_->currentIndex() != 0 ? 1 : 0);
  count_->setText(count == 0 ? QString() : QStringLiteral("↺ %1").arg(count));
  count_->setAccessibleName(count == 0 ? QString()
                                       : tr("%1 set otherwise than by default").arg(count));
  showTip();
}

const Method& StepForm::chosenMethod() const {
  return step_.methods[static_cast<std::size_t>(method_->currentIndex())];
}

void StepForm::showMethod() {
  delete form_;
  form_ = new MethodForm(chosenMethod(), body_);
  form_->setScale(scale_, unit_);
  form_->setDensities(densities_);
  connect(form_, &MethodForm::changed, this, &StepForm::changed);
  column_->addWidget(form_);
}

} // namespace espalier
