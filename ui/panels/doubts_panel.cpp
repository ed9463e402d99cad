#include "ui/panels/doubts_panel.h"

#include "ui/document/doubt_text.h"
#include "ui/document/length_unit.h"
#include "ui/document/plant_document.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/panel_button.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr int doubtRole = Qt::UserRole; // the number of a doubt; none for a group

QString percentOf(double share) {
  return DoubtsPanel::tr("%1 %").arg(std::lround(100 * share));
}

} // namespace

DoubtsPanel::DoubtsPanel(const PlantDocument& document, const Actions& actions, QWidget* parent)
    : QWidget(parent), document_(document), actions_(actions),
      title_(makeLabel("doubts_title", "title")),
      agreement_(makeLabel("doubts_agreement", "value")), note_(makeLabel("doubts_note", "quiet")),
      question_(makeLabel("doubts_question", "value")), asked_(new QWidget),
      list_(new QTreeWidget) {
  setObjectName("doubts_panel");
  for (QLabel* label : {title_, agreement_, note_, question_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(72);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 12, 8, 12);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(agreement_);
  column->addWidget(note_);
  column->addWidget(sharingButton(*actions.ask));
  auto* asked = new QVBoxLayout(asked_);
  asked->setContentsMargins(0, 0, 0, 0);
  asked->setSpacing(4);
  asked->addWidget(question_);
  for (QAction* answer : actions.answers) {
    auto* button = new QToolButton; // its text is the answer's, once something is asked
    button->setText(answer->text());
    button->setObjectName(answer->objectName() + "_button");
    button->setProperty("role", "panel");
    button->setMinimumWidth(40);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, answer, &QAction::trigger);
    answers_.push_back(button);
    asked->addWidget(button);
  }
  none_ = sharingButton(*actions.none);
  asked->addWidget(none_);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(sharingButton(*actions.takeBack, tr("◂ Take Back")));
  row->addWidget(sharingButton(*actions.skip, tr("Skip ▸")));
  asked->addLayout(row);
  column->addWidget(asked_);
  list_->setObjectName("doubts_list");
  list_->setAccessibleName(tr("Doubts"));
  list_->setColumnCount(2);
  list_->setHeaderLabels({tr("Doubt"), tr("Wrong")});
  list_->headerItem()->setToolTip(1, tr("How probably the plant is not as it is there"));
  list_->setRootIsDecorated(true);
  list_->setIndentation(12);
  list_->setUniformRowHeights(true);
  list_->setMinimumWidth(72);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  onEnter(*list_, [this] { reportChosen(list_->currentItem()); });
  connect(list_, &QTreeWidget::itemClicked, this,
          [this](const QTreeWidgetItem* item) { reportChosen(item); });
  column->addWidget(list_, 1);
  column->addWidget(sharingButton(*actions.decideRest));
  show({}, 0);
  showAgreement({}, true);
  showNote({});
  setCurrent(std::nullopt, false);
}

void DoubtsPanel::show(const std::vector<Doubt>& doubts, std::size_t all) {
  {
    const QSignalBlocker blocker(list_);
    listed_ = doubts;
    list_->clear();
    for (int kind = 0; kind < doubtKinds; ++kind)
      addGroup(static_cast<Doubt::Kind>(kind));
  }
  list_->setVisible(!listed_.empty());
  title_->setText(all == 1 ? tr("1 doubt") : tr("%1 doubts").arg(formatCount(all)));
  title_->setVisible(!listed_.empty());
}

void DoubtsPanel::addGroup(Doubt::Kind kind) {
  const auto count = std::ranges::count(listed_, kind, &Doubt::kind);
  if (count == 0) return;
  const QString title =
      tr("%1 (%2)").arg(titleOf(kind), formatCount(static_cast<std::size_t>(count)));
  auto* group = new QTreeWidgetItem(list_, {title});
  group->setFirstColumnSpanned(true);
  group->setToolTip(0, title);
  for (std::size_t i = 0; i < listed_.size(); ++i) {
    const Doubt& doubt = listed_[i];
    if (doubt.kind != kind) continue;
    auto* item = new QTreeWidgetItem(
        group, {formatLength(doubt.length, document_.unit(), 2), percentOf(doubt.wrong())});
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    const QString question = questionOf(doubt, document_.unit());
    item->setToolTip(0, question);
    item->setData(0, Qt::AccessibleDescriptionRole, question);
    item->setData(0, doubtRole, static_cast<qulonglong>(i));
  }
  group->setExpanded(true);
}

void DoubtsPanel::showAgreement(const QString& text, bool isOfNow) {
  agreement_->setText(text);
  agreement_->setEnabled(isOfNow);
  agreement_->setToolTip(isOfNow ? QString()
                                 : tr("Of the plant before the last edits: it is computed anew"));
  agreement_->setVisible(!text.isEmpty());
}

void DoubtsPanel::showNote(const QString& text) {
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

void DoubtsPanel::setCurrent(const std::optional<Doubt>& doubt, bool isByHand) {
  asked_->setVisible(doubt.has_value());
  none_->setVisible(!isByHand);
  if (!doubt) return;
  question_->setText(isByHand ? tr("Correct it with any tool, or go on")
                              : questionOf(*doubt, document_.unit()));
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    const bool isThere = !isByHand && i < doubt->alternatives.size();
    answers_[i]->setVisible(isThere);
    if (!isThere) continue;
    const Alternative& one = doubt->alternatives[i];
    answers_[i]->setText(
        tr("%1  %2 · %3").arg(i + 1).arg(textOf(*doubt, one), percentOf(one.probability)));
  }
}

void DoubtsPanel::reportChosen(const QTreeWidgetItem* item) {
  if (item == nullptr || !item->data(0, doubtRole).isValid()) return;
  const Doubt doubt = listed_[item->data(0, doubtRole).toULongLong()];
  emit chosen(doubt);
}

} // namespace espalier
