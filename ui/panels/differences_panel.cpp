#include "ui/panels/differences_panel.h"

#include "ui/document/difference_look.h"
#include "ui/document/plant_document.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/panel_button.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace espalier {
namespace {

constexpr int partRole = Qt::UserRole;        // of a part
constexpr int sortRole = Qt::UserRole + 1;    // to sort by
constexpr int ignoredRole = Qt::UserRole + 2; // whether it is
enum PartColumn { partKind, partLength, partPlace, partColumns };

/// Sorts lengths as numbers, ignored parts after all others.
class Row : public QTreeWidgetItem {
public:
  using QTreeWidgetItem::QTreeWidgetItem;
  bool operator<(const QTreeWidgetItem& other) const override {
    const bool isIgnored = data(0, ignoredRole).toBool();
    const bool isOtherIgnored = other.data(0, ignoredRole).toBool();
    const bool isUp = treeWidget()->header()->sortIndicatorOrder() == Qt::AscendingOrder;
    if (isIgnored != isOtherIgnored) return isIgnored != isUp;
    const int column = treeWidget()->sortColumn();
    if (column != partKind)
      return data(column, sortRole).toDouble() < other.data(column, sortRole).toDouble();
    const double kind = data(partKind, sortRole).toDouble();
    const double otherKind = other.data(partKind, sortRole).toDouble();
    if (kind != otherKind) return kind < otherKind;
    return data(partLength, sortRole).toDouble() < other.data(partLength, sortRole).toDouble();
  }
};

/// A piece of line as it is drawn in the view: what is missed is dotted.
QIcon iconOf(Difference kind, double ratio) {
  QPixmap pixmap(QSize(16, 16) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const Color color = colorOf(kind);
  QPen pen(QColor(color[0], color[1], color[2]), 3);
  if (kind == Difference::missed) pen.setDashPattern({1, 0.8});
  painter.setPen(pen);
  if (kind == Difference::wronglyAttached)
    painter.drawPolyline(QPolygonF({QPointF(3, 14), QPointF(3, 7), QPointF(13, 3)}));
  else
    painter.drawLine(QPointF(3, 14), QPointF(13, 3));
  return QIcon(pixmap);
}

QString helpOf(const DifferingPart& part, const QString& length) {
  switch (part.kind) {
  case Difference::missed:
    return DifferencesPanel::tr("The reference has %1 here that the plant lacks").arg(length);
  case Difference::invented:
    return DifferencesPanel::tr("The plant has %1 here that the reference lacks").arg(length);
  case Difference::wronglyAttached:
    return DifferencesPanel::tr("%1 of the plant are attached to something else in the reference")
        .arg(length);
  case Difference::matched:
    break;
  }
  return {};
}

QString placeOf(const DifferingPart& part) {
  if (part.kind == Difference::missed)
    return part.host ? DifferencesPanel::tr("on node %1").arg(indexOf(*part.host))
                     : DifferencesPanel::tr("beside the plant");
  const NodeId node = part.kind == Difference::wronglyAttached ? part.attached : part.nodes.front();
  return DifferencesPanel::tr("node %1").arg(indexOf(node));
}

} // namespace

DifferencesPanel::DifferencesPanel(const PlantDocument& document, const Actions& actions,
                                   QWidget* parent)
    : QWidget(parent), document_(document), title_(new QLabel), showIgnored_(new QToolButton),
      list_(new QTreeWidget) {
  setObjectName("differences_panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* head = new QHBoxLayout;
  title_->setObjectName("differences_title");
  head->setSpacing(4);
  head->addWidget(title_);
  showIgnored_->setObjectName("differences_ignored");
  showIgnored_->setCheckable(true);
  showIgnored_->setProperty("role", "panel");
  head->addWidget(showIgnored_);
  head->addStretch();
  head->addWidget(panelButton(*actions.previous, QStringLiteral("◂")));
  head->addWidget(panelButton(*actions.next, QStringLiteral("▸")));
  for (QAction* action :
       {actions.accept, actions.ignore}) { // which say by their keys what is missing
    QToolButton* button = panelButton(*action);
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    const auto enable = [this, button] { button->setEnabled(current().has_value()); };
    connect(action, &QAction::changed, button, enable);
    connect(this, &DifferencesPanel::currentChanged, button, enable);
    head->addWidget(button);
  }
  column->addLayout(head);
  list_->setObjectName("differences_list");
  list_->setAccessibleName(tr("Errors"));
  list_->setColumnCount(partColumns);
  list_->setHeaderLabels({tr("Error"), tr("Length"), tr("Place")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setSortingEnabled(true);
  list_->sortByColumn(partLength, Qt::DescendingOrder);
  list_->setMinimumSize(180, 60);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(partKind, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(partLength, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(partPlace, QHeaderView::Stretch);
  onEnter(*list_, [this] { reportChosen(list_->currentItem()); });
  goesThroughRows(*list_);
  list_->installEventFilter(this);
  column->addWidget(list_, 1);
  column->addStretch();
  connect(list_, &QTreeWidget::itemClicked, this,
          [this](const QTreeWidgetItem* item) { reportChosen(item); });
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    if (item != nullptr) gone_ = -1;
    emit currentChanged();
  });
  connect(showIgnored_, &QToolButton::toggled, this, [this](bool areShown) {
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
      if (QTreeWidgetItem* item = list_->topLevelItem(i); item->data(0, ignoredRole).toBool())
        item->setHidden(!areShown);
  });
  show({}, {}, 0);
}

void DifferencesPanel::show(const std::vector<DifferingPart>& parts,
                            const std::vector<DifferingPart>& ignored, double tolerance) {
  const std::optional<DifferingPart> before = current();
  if (before) gone_ = list_->indexOfTopLevelItem(list_->currentItem());
  if (parts.empty() && ignored.empty()) gone_ = -1; // what is listed next is of another
  {
    const QSignalBlocker blocker(list_);
    list_->setSortingEnabled(false);
    list_->clear();
    listed_.clear();
    for (const DifferingPart& part : parts)
      addItem(part, false);
    for (const DifferingPart& part : ignored)
      addItem(part, true);
    list_->setSortingEnabled(true);
    restoreCurrent(before, tolerance);
  }
  count_ = parts.size();
  ignored_ = ignored.size();
  refreshTitle();
  endBetweenRows();
  emit currentChanged();
}

std::optional<DifferingPart> DifferencesPanel::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  if (item == nullptr) return std::nullopt;
  return listed_[item->data(0, partRole).toULongLong()];
}

std::optional<DifferingPart> DifferencesPanel::step(int by) {
  const int count = static_cast<int>(count_); // what is ignored follows
  if (count == 0) return std::nullopt;
  int row = by > 0 ? 0 : count - 1;
  if (list_->currentItem() != nullptr)
    row = list_->indexOfTopLevelItem(list_->currentItem()) + by;
  else if (gone_ >= 0)
    row = by > 0 ? gone_ : gone_ - 1;
  QTreeWidgetItem* item = list_->topLevelItem((row % count + count) % count);
  list_->setCurrentItem(item);
  list_->scrollToItem(item);
  return current();
}

void DifferencesPanel::addItem(const DifferingPart& part, bool isIgnored) {
  const QString length = formatLength(part.length, document_.unit(), 3);
  auto* item = new Row(list_, {titleOf(part.kind), length, placeOf(part)});
  item->setIcon(partKind, iconOf(part.kind, devicePixelRatioF()));
  item->setTextAlignment(partLength, Qt::AlignRight | Qt::AlignVCenter);
  item->setData(partKind, sortRole, static_cast<double>(part.kind));
  item->setData(partLength, sortRole, part.length);
  item->setData(partPlace, sortRole, part.at.z());
  item->setData(0, partRole, static_cast<qulonglong>(listed_.size()));
  item->setData(0, ignoredRole, isIgnored);
  const QString help =
      isIgnored ? tr("Ignored: %1").arg(helpOf(part, length)) : helpOf(part, length);
  for (int column = 0; column < partColumns; ++column) {
    item->setToolTip(column, help);
    if (isIgnored) item->setForeground(column, palette().placeholderText());
  }
  item->setHidden(isIgnored && !showIgnored_->isChecked());
  listed_.push_back(part);
}

void DifferencesPanel::restoreCurrent(const std::optional<DifferingPart>& part, double tolerance) {
  if (!part) return;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    const DifferingPart& other = listed_[item->data(0, partRole).toULongLong()];
    if (item->isHidden() || !isSame(other, *part, tolerance)) continue;
    list_->setCurrentItem(item);
    list_->scrollToItem(item);
    gone_ = -1;
    return;
  }
  list_->setCurrentItem(nullptr);
}

void DifferencesPanel::refreshTitle() {
  title_->setText(count_ == 1 ? tr("1 error") : tr("%1 errors").arg(formatCount(count_)));
  showIgnored_->setVisible(ignored_ > 0);
  showIgnored_->setText(tr("%1 ignored").arg(formatCount(ignored_)));
}

void DifferencesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  endBetweenRows();
}

/// The last row that is seen is not sliced.
void DifferencesPanel::endBetweenRows() {
  const int row = list_->sizeHintForRow(0);
  const int rest = list_->header()->sizeHint().height() + 2 * list_->frameWidth();
  const int room = height() - list_->y() - rest;
  list_->setMaximumHeight(row > 0 ? rest + std::max(room / row, 1) * row : QWIDGETSIZE_MAX);
}

/// The keys that go through a list choose what they come to.
bool DifferencesPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != list_ || event->type() != QEvent::KeyRelease) return false;
  const auto* release = static_cast<QKeyEvent*>(event);
  const std::array keys = {Qt::Key_Up,       Qt::Key_Down, Qt::Key_PageUp,
                           Qt::Key_PageDown, Qt::Key_Home, Qt::Key_End};
  if (std::ranges::find(keys, release->key()) != keys.end() && !release->isAutoRepeat())
    reportChosen(list_->currentItem());
  return false;
}

void DifferencesPanel::reportChosen(const QTreeWidgetItem* item) {
  if (item == nullptr) return;
  const DifferingPart part = listed_[item->data(0, partRole).toULongLong()];
  emit chosen(part);
}

} // namespace espalier
