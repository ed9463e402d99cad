#include "ui/panels/envelope_panel.h"

#include "ui/document/shown_text.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/method_form.h"
#include "ui/panels/option_field.h"
#include "ui/panels/panel_button.h"
#include "ui/panels/wide_enough.h"

#include <QAction>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {
namespace {

QComboBox* makeCombo(const QString& name, const QString& accessible) {
  auto* combo = new QComboBox;
  combo->setObjectName(name);
  combo->setAccessibleName(accessible);
  combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  combo->setMinimumContentsLength(8);
  opensOnEnter(*combo);
  return combo;
}

QLabel* makeWrapped(const char* name, const char* role) {
  QLabel* label = makeLabel(name, role);
  label->setWordWrap(true);
  label->setMinimumWidth(72);
  return label;
}

} // namespace

std::vector<std::string> EnvelopeChoice::settings() const {
  std::vector<std::string> result;
  for (const Option& option : kind->form.options) {
    const auto set = options.find(option.name);
    if (set == options.end()) continue;
    result.push_back(
        option.name + "=" +
        (option.takesWords() ? option.wordFor(set->second.fixed) : set->second.text()));
  }
  return result;
}

EnvelopePanel::EnvelopePanel(QAction& write, QWidget* parent)
    : QWidget(parent), kind_(makeCombo("envelope_kind", tr("Shape of the envelope"))),
      about_(makeCombo("envelope_about", tr("What the envelope is about"))), body_(new QWidget),
      formPlace_(new QVBoxLayout), numbersPlace_(new QVBoxLayout),
      words_(makeWrapped("envelope_words", "quiet")),
      handles_(makeWrapped("envelope_handles", "quiet")), fit_(new QPushButton(tr("Fit Again"))),
      write_(panelButton(write)) {
  setObjectName("envelope_panel");
  kind_->addItem(tr("None"));
  for (const EnvelopeKind& kind : envelopeKinds()) {
    kind_->addItem(shownText(kind.form.label), QString::fromStdString(kind.form.name));
    kind_->setItemData(kind_->count() - 1, shownText(kind.form.help), Qt::ToolTipRole);
  }
  about_->addItem(tr("About the points"));
  about_->addItem(tr("About the skeleton"));
  fit_->setObjectName("envelope_fit");
  fit_->setToolTip(tr("Forgets what was dragged: all follows from the plant"));
  write_->setObjectName("envelope_write");
  auto* body = new QVBoxLayout(body_);
  body->setContentsMargins(0, 0, 0, 0);
  body->setSpacing(8);
  body->addWidget(about_);
  body->addLayout(formPlace_);
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(12, 12, 8, 12);
  column->setSpacing(8);
  column->addWidget(kind_);
  column->addWidget(body_);
  column->addWidget(words_);
  column->addLayout(numbersPlace_);
  column->addWidget(handles_);
  column->addWidget(fit_);
  column->addWidget(write_);
  column->addStretch(1);
  auto* area = new QScrollArea;
  area->setAccessibleName(tr("Crown envelope"));
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  keepWideEnough(*area);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(area);
  connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
    makeForm();
    emit changed();
  });
  connect(about_, &QComboBox::currentIndexChanged, this, &EnvelopePanel::changed);
  connect(fit_, &QPushButton::clicked, this, &EnvelopePanel::fitRequested);
  makeForm();
}

EnvelopeChoice EnvelopePanel::choice() const {
  if (form_ == nullptr) return {};
  EnvelopeChoice choice{.kind =
                            &envelopeKinds()[static_cast<std::size_t>(kind_->currentIndex() - 1)],
                        .isOfSkeleton = about_->currentIndex() == 1};
  for (const OptionField* field : form_->fields())
    if (field->chosen()) choice.options[field->option().name] = *field->chosen();
  return choice;
}

void EnvelopePanel::setChoice(const EnvelopeChoice& choice) {
  const QSignalBlocker blocker(this);
  const int index =
      choice.kind == nullptr ? 0 : static_cast<int>(choice.kind - envelopeKinds().data()) + 1;
  kind_->setCurrentIndex(index);
  about_->setCurrentIndex(choice.isOfSkeleton ? 1 : 0);
  makeForm();
  if (form_ == nullptr) return;
  for (OptionField* field : form_->fields())
    if (const auto set = choice.options.find(field->option().name); set != choice.options.end())
      field->choose(set->second);
}

/// Of the kind that is chosen, with nothing set.
void EnvelopePanel::makeForm() {
  delete form_;
  form_ = nullptr;
  if (kind_->currentIndex() > 0) {
    form_ = new MethodForm(
        envelopeKinds()[static_cast<std::size_t>(kind_->currentIndex() - 1)].form, body_);
    form_->setObjectName("envelope_form");
    form_->setScale(scale_, unit_);
    formPlace_->addWidget(form_);
    connect(form_, &MethodForm::changed, this, &EnvelopePanel::changed);
  }
  showWords(form_ == nullptr ? tr("Choose a shape: it is drawn about the plant, and measured. From "
                                  "height leaves out a bare stem.")
                             : QString());
}

void EnvelopePanel::setScale(const PlantScale& scale, const QString& unit) {
  scale_ = scale;
  unit_ = unit;
  if (form_ != nullptr) form_->setScale(scale, unit);
}

void EnvelopePanel::setHasPoints(bool hasPoints) {
  if (auto* model = qobject_cast<QStandardItemModel*>(about_->model()))
    model->item(0)->setEnabled(hasPoints);
  about_->setEnabled(hasPoints);
}

void EnvelopePanel::makeNumbers(const std::vector<Number>& numbers) {
  delete numbers_;
  values_.clear();
  numbers_ = new QWidget;
  numbers_->setObjectName("envelope_numbers");
  auto* grid = new QGridLayout(numbers_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(0, 1);
  for (const Number& number : numbers) {
    auto* label = new QLabel(number.label);
    label->setWordWrap(true);
    label->setToolTip(number.help);
    QLabel* value = makeLabel("envelope_value", "value");
    value->setToolTip(number.help);
    value->setAccessibleName(number.label);
    value->setAlignment(Qt::AlignRight | Qt::AlignTop);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const int row = static_cast<int>(values_.size());
    grid->addWidget(label, row, 0);
    grid->addWidget(value, row, 1);
    values_.push_back(value);
  }
  numbersPlace_->addWidget(numbers_);
  numbers_->show(); // now, not once the layout comes to it
}

void EnvelopePanel::showNumbers(const std::vector<Number>& numbers, const QString& handles,
                                bool isByHand) {
  const bool areThere =
      std::ranges::equal(numbers, values_, [](const Number& number, const QLabel* value) {
        return number.label == value->accessibleName();
      });
  if (!areThere) makeNumbers(numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    values_[i]->setText(numbers[i].text);
    setRole(*values_[i], "value");
  }
  words_->hide();
  handles_->setText(handles);
  handles_->show();
  fit_->setVisible(isByHand);
  write_->setVisible(true);
  refresh();
}

void EnvelopePanel::showWords(const QString& words) {
  delete numbers_;
  numbers_ = nullptr;
  values_.clear();
  words_->setText(words);
  words_->setVisible(!words.isEmpty());
  handles_->hide();
  fit_->hide();
  write_->hide();
  refresh();
}

void EnvelopePanel::showDrawing(const QString& words) {
  words_->setText(words);
  words_->show();
}

void EnvelopePanel::setStale(bool isStale) {
  for (QLabel* value : values_)
    setRole(*value, isStale ? "quiet" : "value");
}

void EnvelopePanel::refresh() {
  body_->setVisible(form_ != nullptr);
}

} // namespace espalier
