#include "ui/panels/clean_panel.h"

#include "ui/document/shown_text.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/method_form.h"
#include "ui/panels/option_field.h"
#include "ui/panels/panel_button.h"
#include "ui/panels/wide_enough.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace espalier {
namespace {

QHBoxLayout* makeRow(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  column.addLayout(row);
  return row;
}

QLabel* makeLine(const char* name, const char* role) {
  QLabel* label = makeLabel(name, role);
  label->setWordWrap(true);
  label->setMinimumWidth(72);
  return label;
}

void addButtons(QVBoxLayout& column, const QString& title,
                const std::vector<std::pair<QAction*, QString>>& actions) {
  column.addSpacing(8);
  column.addWidget(new QLabel(title));
  QHBoxLayout* row = makeRow(column);
  for (const auto& [action, text] : actions)
    row->addWidget(sharingButton(*action, text));
}

} // namespace

CleanPanel::CleanPanel(const Actions& actions, QWidget* parent)
    : QWidget(parent), methods_(cleaningMethods()), chosen_(new QComboBox), body_(new QWidget),
      again_(new QPushButton(tr("Find Again"))), result_(makeLine("clean_result", "quiet")),
      cancel_(new QPushButton(tr("Cancel"))), setAside_(new QPushButton(tr("Set Aside"))),
      aside_(makeLine("clean_aside", "quiet")) {
  setObjectName("clean_panel");
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(12, 12, 8, 12);
  column->setSpacing(8);
  addChoice(*column);
  addButtons(*column, tr("Select by hand"), actions.byHand);
  addButtons(*column, tr("Find by clicks"), actions.byClick);
  column->addStretch(1);
  auto* area = new QScrollArea;
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  keepWideEnough(*area);
  area->setAccessibleName(tr("Cleaning"));
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addWidget(area, 1);
  auto* foot = new QVBoxLayout; // in the same place, however long the form is
  foot->setContentsMargins(12, 8, 8, 12);
  foot->setSpacing(8);
  whole->addLayout(foot);
  addResult(*foot, actions);
}

void CleanPanel::addChoice(QVBoxLayout& column) {
  chosen_->setObjectName("clean_method");
  chosen_->setAccessibleName(tr("What to find"));
  chosen_->setPlaceholderText(tr("Choose what to find…"));
  chosen_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  chosen_->setMinimumContentsLength(8);
  opensOnEnter(*chosen_);
  const Step* step = nullptr;
  for (std::size_t i = 0; i < methods_.size(); ++i) {
    if (step != nullptr && step != methods_[i].step) chosen_->insertSeparator(chosen_->count());
    step = methods_[i].step;
    chosen_->addItem(tr("%1: %2").arg(shownText(step->label), shownText(methods_[i].method->label)),
                     static_cast<int>(i));
    chosen_->setItemData(chosen_->count() - 1, shownText(methods_[i].method->help),
                         Qt::ToolTipRole);
  }
  chosen_->setCurrentIndex(-1);
  connect(chosen_, &QComboBox::activated, this, [this] {
    keepOptions();
    showMethod();
    emit changed();
  });
  auto* body = new QVBoxLayout(body_);
  body->setContentsMargins(0, 0, 0, 0);
  column.addWidget(chosen_);
  column.addWidget(body_);
}

void CleanPanel::addResult(QVBoxLayout& column, const Actions& actions) {
  result_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  result_->setMinimumHeight(3 * result_->fontMetrics().lineSpacing()); // buttons keep their place
  column.addWidget(result_);
  again_->setObjectName("clean_again");
  again_->setToolTip(tr("Selects once more what the method finds among the points in use"));
  again_->setEnabled(false);
  connect(again_, &QPushButton::clicked, this, &CleanPanel::changed);
  setAside_->setObjectName("clean_set_aside");
  setAside_->setProperty("role", "primary");
  setAside_->setToolTip(tr("The selected points take part in nothing until they are brought back"));
  setAside_->setEnabled(false);
  connect(setAside_, &QPushButton::clicked, this, &CleanPanel::setAsideRequested);
  cancel_->setObjectName("clean_cancel");
  cancel_->hide();
  connect(cancel_, &QPushButton::clicked, this, &CleanPanel::cancelRequested);
  QHBoxLayout* found = makeRow(column);
  for (QPushButton* button : {again_, setAside_, cancel_}) {
    button->setMinimumWidth(40);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // they widen no panel
    found->addWidget(button, button->sizeHint().width());            // each as its text needs
  }
  QHBoxLayout* other = makeRow(column);
  other->addWidget(sharingButton(*actions.keepOnly, tr("Keep Only")));
  other->addWidget(sharingButton(*actions.invert, tr("Invert")));
  aside_->setMinimumHeight(2 * aside_->fontMetrics().lineSpacing());
  column.addWidget(aside_);
  QHBoxLayout* back = makeRow(column);
  back->addWidget(sharingButton(*actions.showAside, tr("Show")), 1);
  back->addWidget(sharingButton(*actions.bringBack, {}), 2); // with the longer text
}

void CleanPanel::setScale(const PlantScale& scale, const QString& unit) {
  scale_ = scale;
  unit_ = unit;
  if (form_ != nullptr) form_->setScale(scale, unit);
}

std::optional<CleanPanel::Choice> CleanPanel::choice() const {
  if (form_ == nullptr) return std::nullopt;
  return Choice{methods_[static_cast<std::size_t>(chosen_->currentData().toInt())],
                form_->values()};
}

void CleanPanel::forgetChoice() {
  options_.clear();
  chosen_->setCurrentIndex(-1);
  showMethod();
}

void CleanPanel::keepOptions() {
  if (form_ == nullptr) return;
  std::vector<std::optional<Rule>>& options = options_[&form_->method()];
  options.clear();
  for (const OptionField* field : form_->fields())
    options.push_back(field->chosen());
}

void CleanPanel::showMethod() {
  delete form_;
  form_ = nullptr;
  again_->setEnabled(chosen_->currentIndex() >= 0);
  if (chosen_->currentIndex() < 0) return;
  form_ = new MethodForm(*methods_[static_cast<std::size_t>(chosen_->currentData().toInt())].method,
                         body_);
  form_->setScale(scale_, unit_);
  if (const auto kept = options_.find(&form_->method()); kept != options_.end())
    for (std::size_t i = 0; i < kept->second.size(); ++i)
      form_->fields()[i]->choose(kept->second[i]);
  connect(form_, &MethodForm::changed, this, &CleanPanel::changed);
  body_->layout()->addWidget(form_);
}

void CleanPanel::showFinding(double fraction) {
  result_->setText(tr("Looking for them… %1 %").arg(static_cast<int>(100 * fraction)));
  cancel_->show();
  passFocus(*setAside_, *cancel_);
  setAside_->hide();
}

void CleanPanel::showSelected(const QString& text, bool mayBeSetAside) {
  result_->setText(text);
  passFocus(*cancel_, *again_);
  cancel_->hide();
  setAside_->show();
  if (!mayBeSetAside) passFocus(*setAside_, *chosen_);
  setAside_->setEnabled(mayBeSetAside);
}

void CleanPanel::showAside(const QString& text) {
  aside_->setText(text);
}

} // namespace espalier
