#include "ui/panels/findings_panel.h"

#include "ui/document/finding_title.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/panels/check_form.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/panel_button.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSet>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

using Kind = Finding::Kind;

constexpr int numberRole = Qt::UserRole; // of a finding; none for a group
constexpr int groupRole = Qt::UserRole + 1;
constexpr int ignoredGroup = findingKinds;

} // namespace

FindingsPanel::FindingsPanel(const PlantDocument& document, const Actions& actions, QWidget* parent)
    : QWidget(parent), document_(document), title_(makeLabel("findings_title", "title")),
      note_(makeLabel("findings_note", "quiet")),
      sentence_(makeLabel("findings_sentence", "quiet")), list_(new QTreeWidget),
      walk_(new QWidget), checks_(new CheckForm) {
  setObjectName("findings_panel");
  walk_->setObjectName("findings_walk");
  for (QLabel* label : {title_, note_, sentence_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(72);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 12, 8, 12);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(note_);
  list_->setObjectName("findings_list");
  list_->setAccessibleName(tr("Findings"));
  list_->setColumnCount(2);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(true);
  list_->setIndentation(12);
  list_->setUniformRowHeights(true);
  list_->setMinimumWidth(72);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  onEnter(*list_, [this] { reportChosen(list_->currentItem()); });
  column->addWidget(list_, 2);
  column->addWidget(sentence_);
  auto* walk = new QHBoxLayout(walk_);
  walk->setContentsMargins(0, 0, 0, 0);
  walk->setSpacing(4);
  walk->addWidget(sharingButton(*actions.previous, tr("◂ Previous")));
  walk->addWidget(sharingButton(*actions.next, tr("Next ▸")));
  column->addWidget(walk_);
  ignore_ = sharingButton(*actions.ignore);
  ignore_->setObjectName("findings_ignore");
  const auto enable = [this] { ignore_->setEnabled(current().has_value()); };
  connect(actions.ignore, &QAction::changed, ignore_, enable); // its key says what is missing
  connect(this, &FindingsPanel::currentChanged, ignore_, enable);
  column->addWidget(ignore_);
  column->addWidget(checks_, 1);
  connect(list_, &QTreeWidget::itemClicked, this,
          [this](const QTreeWidgetItem* item) { reportChosen(item); });
  connect(list_, &QTreeWidget::currentItemChanged, this, &FindingsPanel::currentChanged);
  show({}, {});
  showSentence({});
  setChecking(false);
}

void FindingsPanel::show(const std::vector<Finding>& findings,
                         const std::vector<Finding>& ignored) {
  const std::optional<Finding> before = current();
  QSet<int> folded; // groups that one has closed, or of the ignored, has not opened
  for (int i = 0; i < list_->topLevelItemCount(); ++i)
    if (!list_->topLevelItem(i)->isExpanded())
      folded.insert(list_->topLevelItem(i)->data(0, groupRole).toInt());
  if (listed_.empty() || !list_->topLevelItemCount()) folded.insert(ignoredGroup);
  {
    const QSignalBlocker blocker(list_);
    list_->clear();
    listed_.clear();
    for (int kind = 0; kind < findingKinds; ++kind) {
      std::vector<Finding> group;
      for (const Finding& finding : findings)
        if (finding.kind == static_cast<Kind>(kind)) group.push_back(finding);
      addGroup(titleOf(static_cast<Kind>(kind)), group, !folded.contains(kind), false);
    }
    addGroup(tr("Ignored"), ignored, !folded.contains(ignoredGroup), true);
    restoreCurrent(before);
  }
  count_ = findings.size();
  refreshTexts();
  list_->setVisible(!listed_.empty());
  walk_->setVisible(!findings.empty());
  ignore_->setVisible(!listed_.empty());
  emit currentChanged();
}

void FindingsPanel::setChecking(bool isChecking) {
  isChecking_ = isChecking;
  refreshTexts();
}

void FindingsPanel::setCurrent(const Finding& finding) {
  restoreCurrent(finding);
}

void FindingsPanel::showSentence(const QString& text) {
  sentence_->setText(text);
  sentence_->setVisible(!text.isEmpty());
}

std::optional<Finding> FindingsPanel::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  if (item == nullptr || !item->data(0, numberRole).isValid()) return std::nullopt;
  return listed_[item->data(0, numberRole).toULongLong()];
}

void FindingsPanel::addGroup(const QString& title, const std::vector<Finding>& findings,
                             bool isOpen, bool isIgnored) {
  if (findings.empty()) return;
  auto* group = new QTreeWidgetItem(list_, {title, formatCount(findings.size())});
  group->setData(0, groupRole, isIgnored ? ignoredGroup : static_cast<int>(findings.front().kind));
  group->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  group->setToolTip(0, title);
  for (const Finding& finding : findings) {
    auto* item = new QTreeWidgetItem(group, {textOf(finding)});
    item->setFirstColumnSpanned(true);
    const auto length = [this](double value) {
      return formatLength(value, document_.unit(), 3).toStdString();
    };
    QString whole = shownText(describe(finding, document_.skeleton(), length));
    whole[0] = whole[0].toUpper();
    item->setToolTip(0, whole);
    item->setData(0, numberRole, static_cast<qulonglong>(listed_.size()));
    item->setData(0, Qt::AccessibleDescriptionRole, whole);
    listed_.push_back(finding);
  }
  group->setExpanded(isOpen);
}

void FindingsPanel::refreshTexts() {
  note_->setText(document_.skeleton().isEmpty() ? QString()
                 : isChecking_                  ? tr("Checking against the scan…")
                 : document_.scan() == nullptr  ? tr("Open a scan to check against it")
                                                : QString());
  note_->setVisible(!note_->text().isEmpty());
  if (document_.skeleton().isEmpty())
    title_->setText(tr("There is no skeleton to check yet"));
  else if (count_ > 0)
    title_->setText(count_ == 1 ? tr("1 finding") : tr("%1 findings").arg(formatCount(count_)));
  else
    title_->setText(isChecking_ ? tr("Nothing to look at so far")
                                : tr("Nothing to look at: all checks pass"));
}

void FindingsPanel::restoreCurrent(const std::optional<Finding>& finding) {
  if (!finding) return;
  for (int i = 0; i < list_->topLevelItemCount(); ++i)
    for (int k = 0; k < list_->topLevelItem(i)->childCount(); ++k) {
      QTreeWidgetItem* item = list_->topLevelItem(i)->child(k);
      if (!isSame(listed_[item->data(0, numberRole).toULongLong()], *finding)) continue;
      list_->setCurrentItem(item);
      if (item->parent()->isExpanded()) list_->scrollToItem(item);
      return;
    }
}

void FindingsPanel::reportChosen(const QTreeWidgetItem* item) {
  if (item == nullptr || !item->data(0, numberRole).isValid()) return;
  const Finding finding = listed_[item->data(0, numberRole).toULongLong()];
  emit chosen(finding);
}

/// Short: the kind is written over it, and the whole sentence is its tool tip.
QString FindingsPanel::textOf(const Finding& finding) const {
  const auto length = [this](double value) { return formatLength(value, document_.unit(), 3); };
  QString node = tr("node %1").arg(indexOf(finding.node));
  const qulonglong other = finding.others.empty() ? 0 : indexOf(finding.others.front());
  const qlonglong count = std::llround(finding.amount);
  switch (finding.kind) {
  case Kind::separatePiece:
    return count == 1 ? tr("%1 · alone").arg(node) : tr("%1 · %2 nodes").arg(node).arg(count);
  case Kind::twoSuccessors:
    return tr("%1 · %2").arg(node).arg(count);
  case Kind::loneBranch:
  case Kind::noLength:
    return node;
  case Kind::duplicatedEdge:
    return tr("%1 on %2").arg(node).arg(other);
  case Kind::sharpTurn:
    return tr("%1 · %2°").arg(node).arg(std::lround(finding.amount * 180 / std::numbers::pi));
  case Kind::crossing:
  case Kind::loop:
    return tr("%1 and %2").arg(node).arg(other);
  case Kind::radiusAboveParent:
  case Kind::edgesWithoutPoints:
  case Kind::noOwnPoints:
  case Kind::besidePoints:
  case Kind::shortFoot:
    return tr("%1 · %2").arg(node, length(finding.amount));
  case Kind::unexplainedPoints:
    return tr("%1 points · %2")
        .arg(formatCount(static_cast<std::size_t>(count)), length(2 * finding.reach));
  }
  return {};
}

} // namespace espalier
