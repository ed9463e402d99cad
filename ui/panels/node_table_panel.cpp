#include "ui/panels/node_table_panel.h"

#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/panels/edge_delegate.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/node_table_model.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

NodeTablePanel::NodeTablePanel(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), model_(new NodeTableModel(document, this)),
      table_(new QTableView), filter_(new QLineEdit),
      onlySelected_(new QCheckBox(tr("Selected only"))), count_(makeLabel("node_count", "quiet")),
      wrong_(makeLabel("node_filter_wrong", "warning")) {
  setObjectName("node_table_panel");
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(12, 8, 12, 8);
  page->setSpacing(8);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  filter_->setObjectName("node_filter");
  filter_->setAccessibleName(tr("Filter of the nodes"));
  filter_->setPlaceholderText(tr("Filter: radius > 10 and order = 2, or a text"));
  filter_->setClearButtonEnabled(true);
  onlySelected_->setObjectName("only_selected");
  count_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // must not widen the panel
  auto* copy = new QPushButton(tr("Copy Table"));
  copy->setObjectName("copy_table");
  copy->setToolTip(tr("Copies the selected rows, or all, for a spreadsheet"));
  row->addWidget(filter_, 2);
  row->addWidget(onlySelected_);
  row->addWidget(count_, 3);
  row->addWidget(copy);
  page->addLayout(row);
  wrong_->hide();
  page->addWidget(wrong_);
  makeTable();
  page->addWidget(table_, 1);
  later_.setSingleShot(true);
  later_.setInterval(60); // [ms]: the rows of a drag are found again when it rests
  connect(copy, &QPushButton::clicked, this, &NodeTablePanel::copyRequested);
  connectParts();
}

QString NodeTablePanel::table() const {
  std::vector<NodeId> nodes;
  for (int row = 0; row < model_->rowCount(); ++row)
    if (document_.selection().contains(model_->node(row))) nodes.push_back(model_->node(row));
  if (nodes.empty())
    for (int row = 0; row < model_->rowCount(); ++row)
      nodes.push_back(model_->node(row));
  return model_->tableOf(nodes);
}

/// Enter and F2 in the table change a cell, as in tables of other programs; elsewhere they are
/// commands.
bool NodeTablePanel::eventFilter(QObject* watched, QEvent* event) {
  const bool isOverride = event->type() == QEvent::ShortcutOverride;
  if (watched == table_ && (isOverride || event->type() == QEvent::KeyPress)) {
    const int key = static_cast<const QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_F2) {
      const QModelIndex current = table_->currentIndex();
      if (isOverride)
        event->accept();
      else if (current.isValid() && model_->flags(current).testFlag(Qt::ItemIsEditable) &&
               !table_->isPersistentEditorOpen(current)) // whose own Enter comes by here, too
        table_->edit(current);
      return true;
    }
    if (!isOverride && goesToRow(key)) return true;
  }
  return QWidget::eventFilter(watched, event);
}

/// Home and End choose the first and the last row; Up and Down first the present one, if it is not
/// selected, as where it alone is left by the filter.
bool NodeTablePanel::goesToRow(int key) {
  const int rows = model_->rowCount();
  const QModelIndex current = table_->currentIndex();
  if (rows == 0) return false;
  const int column = std::max(current.column(), 0);
  const auto select = [&](int row) {
    table_->setCurrentIndex(model_->index(row, column));
    table_->selectRow(row);
    return true;
  };
  if (key == Qt::Key_Home || key == Qt::Key_End) return select(key == Qt::Key_Home ? 0 : rows - 1);
  const bool isLeft = current.isValid() && !table_->selectionModel()->isRowSelected(current.row());
  return (key == Qt::Key_Up || key == Qt::Key_Down) && isLeft && select(current.row());
}

void NodeTablePanel::makeTable() {
  table_->setObjectName("node_table");
  table_->setAccessibleName(tr("Node Table"));
  table_->setModel(model_);
  table_->setItemDelegateForColumn(static_cast<int>(NodeColumn::edge), new EdgeDelegate(table_));
  table_->setShowGrid(false);
  table_->setMinimumHeight(60); // leaves room for what is wrong with the filter
  table_->setSelectionBehavior(QTableView::SelectRows);
  table_->setEditTriggers(QTableView::DoubleClicked | QTableView::EditKeyPressed);
  table_->setTabKeyNavigation(false); // Tab leaves the table
  goesThroughRows(*table_);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed); // none is measured
  table_->verticalHeader()->setDefaultSectionSize(24);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultSectionSize(68);
  header->setStretchLastSection(true);
  header->setSortIndicator(static_cast<int>(NodeColumn::node), Qt::AscendingOrder);
  for (const NodeColumn narrow :
       {NodeColumn::edge, NodeColumn::order, NodeColumn::axis, NodeColumn::index})
    header->resizeSection(static_cast<int>(narrow), 48);
  for (const NodeColumn number : {NodeColumn::node, NodeColumn::parent, NodeColumn::unit})
    header->resizeSection(static_cast<int>(number), 56);
  for (const NodeColumn wide : {NodeColumn::radius, NodeColumn::length})
    header->resizeSection(static_cast<int>(wide), 90);
  for (const NodeColumn text : {NodeColumn::mark, NodeColumn::review})
    header->resizeSection(static_cast<int>(text), 68);
  for (const NodeColumn text : {NodeColumn::comment, NodeColumn::source}) // in a window of 1280 x
    header->resizeSection(static_cast<int>(text), 109);                   // 800, up to the comment
  table_->setSortingEnabled(true);
  table_->installEventFilter(this);
}

/// Names are longer in some languages, and with some units.
void NodeTablePanel::widenToNames() {
  constexpr int room = 12; // beside a name: what is around it, and half of the arrow of the order
  QHeaderView* header = table_->horizontalHeader();
  for (int column = 0; column < nodeColumns; ++column) {
    const QString name = model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    const int least = header->fontMetrics().horizontalAdvance(name) + room;
    header->resizeSection(column, std::max(header->sectionSize(column), least));
  }
}

void NodeTablePanel::showEvent(QShowEvent* event) {
  widenToNames();
  refresh(); // nothing was read while nobody looked
  QWidget::showEvent(event);
}

void NodeTablePanel::refresh() {
  later_.stop();
  model_->update();
  if (onlySelected_->isChecked())
    listSelected();
  else
    refreshCount();
  showSelection();
}

void NodeTablePanel::connectParts() {
  connect(filter_, &QLineEdit::textChanged, this, &NodeTablePanel::useFilter);
  connect(onlySelected_, &QCheckBox::toggled, this, [this](bool isOn) {
    if (isOn)
      listSelected();
    else
      model_->show(std::nullopt);
  });
  // A reset forgets the selected rows, whatever it was for.
  connect(model_, &NodeTableModel::modelReset, this, [this] {
    showSelection();
    refreshCount();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &NodeTablePanel::takeSelection);
  connect(&document_.selection(), &Selection::changed, this, [this] {
    if (isSyncing_ || !isVisible()) return;
    if (onlySelected_->isChecked())
      listSelected();
    else
      showSelection();
    refreshCount();
  });
  connect(&later_, &QTimer::timeout, this, &NodeTablePanel::refresh);
  connect(&document_, &PlantDocument::skeletonEdited, this, [this] {
    if (!isVisible()) return;
    model_->refreshCells();
    later_.start();
  });
  connect(&document_, &PlantDocument::skeletonReplaced, this, [this] {
    if (isVisible()) refresh();
  });
  connect(&document_, &PlantDocument::unitChanged, this, [this] {
    emit model_->headerDataChanged(Qt::Horizontal, 0, nodeColumns - 1);
    if (isVisible()) widenToNames();
  });
}

void NodeTablePanel::useFilter() {
  try { // what is wrong is shown beside it: half a condition is no error of a command
    model_->setFilter(NodeFilter(filter_->text()));
    wrong_->hide();
  } catch (const Error& error) {
    QString reason = QString::fromUtf8(error.what());
    reason[0] = reason[0].toUpper();
    wrong_->setText(reason);
    wrong_->show();
  }
  refreshCount();
}

/// Runs of selected rows are one range each: all rows at once are no more work than one.
void NodeTablePanel::showSelection() {
  if (isSyncing_) return;
  const QScopedValueRollback syncing(isSyncing_, true);
  std::vector<int> rows;
  for (const NodeId id : document_.selection().nodes())
    if (const auto row = model_->row(id)) rows.push_back(*row);
  std::ranges::sort(rows);
  QItemSelection ranges;
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t last = first;
    while (last + 1 < rows.size() && rows[last + 1] == rows[last] + 1)
      ++last;
    ranges.append(QItemSelectionRange(model_->index(rows[first], 0),
                                      model_->index(rows[last], nodeColumns - 1)));
    first = last + 1;
  }
  table_->selectionModel()->select(ranges, QItemSelectionModel::ClearAndSelect);
  const std::optional<NodeId> current = document_.selection().current();
  const std::optional<int> row = current ? model_->row(*current) : std::nullopt;
  if (!row) return;
  const QModelIndex index = model_->index(*row, std::max(0, table_->currentIndex().column()));
  table_->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
  table_->scrollTo(index);
}

/// The current row is the node chosen last.
void NodeTablePanel::takeSelection() {
  if (isSyncing_) return;
  const QScopedValueRollback syncing(isSyncing_, true);
  std::vector<NodeId> nodes;
  const QModelIndex current = table_->currentIndex();
  for (const QModelIndex& index : table_->selectionModel()->selectedRows())
    if (index.row() != current.row()) nodes.push_back(model_->node(index.row()));
  if (current.isValid() && table_->selectionModel()->isRowSelected(current.row()))
    nodes.push_back(model_->node(current.row()));
  document_.selection().set(std::move(nodes));
  refreshCount();
}

void NodeTablePanel::listSelected() {
  model_->show(document_.selection().nodes());
}

void NodeTablePanel::refreshCount() {
  const auto rows = static_cast<std::size_t>(model_->rowCount());
  const std::size_t selected = document_.selection().nodes().size();
  if (document_.skeleton().isEmpty())
    count_->setText(tr("There are no nodes yet"));
  else if (onlySelected_->isChecked() && rows == 0 && selected == 0)
    count_->setText(tr("Select nodes to list them"));
  else
    count_->setText(tr("%1 of %2 nodes, %3 selected")
                        .arg(formatCount(rows), formatCount(document_.skeleton().size()),
                             formatCount(selected)));
  count_->setToolTip(count_->text()); // in full where the window is narrow
}

} // namespace espalier
