#include "ui/panels/node_table_model.h"

#include "ui/document/plant_document.h"
#include "ui/document/typed_number.h"

#include <QStringList>

#include <algorithm>
#include <numeric>
#include <utility>

namespace espalier {

NodeTableModel::NodeTableModel(const PlantDocument& document, QObject* parent)
    : QAbstractTableModel(parent), facts_(document) {}

void NodeTableModel::show(std::optional<std::vector<NodeId>> nodes) {
  nodes_ = std::move(nodes);
  list();
}

void NodeTableModel::setFilter(NodeFilter filter) {
  filter_ = std::move(filter);
  list();
}

void NodeTableModel::update() {
  facts_.update();
  list();
}

void NodeTableModel::refreshCells() {
  if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, nodeColumns - 1));
}

std::optional<int> NodeTableModel::row(NodeId id) const {
  if (indexOf(id) >= rowOf_.size() || rowOf_[indexOf(id)] < 0) return std::nullopt;
  return rowOf_[indexOf(id)];
}

QString NodeTableModel::tableOf(const std::vector<NodeId>& nodes) const {
  QStringList cells;
  for (int i = 0; i < nodeColumns; ++i)
    cells.append(headerText(static_cast<NodeColumn>(i), keyOf(static_cast<NodeColumn>(i))));
  QString table = cells.join('\t') + '\n';
  for (const NodeId id : nodes) {
    cells.clear();
    for (int i = 0; i < nodeColumns; ++i) // a comment may have any text: it must stay one cell
      cells.append(facts_.text(id, static_cast<NodeColumn>(i)).simplified());
    table += cells.join('\t') + '\n';
  }
  return table;
}

int NodeTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int NodeTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : nodeColumns;
}

QVariant NodeTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {}; // Ctrl+C where no row is current
  const NodeId id = node(index.row());
  const auto column = static_cast<NodeColumn>(index.column());
  if (!facts_.document().skeleton().contains(id)) return {}; // removed just now
  switch (role) {
  case Qt::DisplayRole:
    return cellText(id, column);
  case Qt::EditRole:
    return facts_.text(id, column);
  case Qt::TextAlignmentRole:
    return QVariant((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  case Qt::ToolTipRole:
    if (column == NodeColumn::comment) return facts_.text(id, column);
    if (flags(index).testFlag(Qt::ItemIsEditable)) return tr("Double click: change it");
    return {};
  default:
    return {};
  }
}

QVariant NodeTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const auto column = static_cast<NodeColumn>(section);
  if (role == Qt::DisplayRole) return headerText(column, nameOf(column));
  if (role == Qt::TextAlignmentRole)
    return QVariant((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  return {};
}

Qt::ItemFlags NodeTableModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
  if (!index.isValid()) return flags;
  const PlantDocument& document = facts_.document();
  const NodeId id = node(index.row());
  if (document.isReadOnly() || !document.skeleton().contains(id)) return flags;
  const auto column = static_cast<NodeColumn>(index.column());
  const bool hasEdge = document.skeleton()[id].parent.has_value();
  const bool isEditable = column == NodeColumn::radius || (column == NodeColumn::edge && hasEdge);
  return isEditable ? flags | Qt::ItemIsEditable : flags;
}

bool NodeTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable)) return false;
  const NodeId id = node(index.row());
  const QString text = value.toString().trimmed();
  if (static_cast<NodeColumn>(index.column()) == NodeColumn::edge) {
    emit edgeChosen(id, text == "+" ? EdgeType::branching : EdgeType::successor);
    return true;
  }
  const bool isOne = !text.contains(' '); // not two numbers
  const std::optional<double> radius = isOne ? typedNumber(text) : std::nullopt;
  if (!radius || *radius < 0) {
    emit refused(tr("“%1” is no radius: type a number that is 0 or more").arg(text));
    return false;
  }
  emit radiusTyped(id, *radius);
  return true;
}

void NodeTableModel::sort(int column, Qt::SortOrder order) {
  if (column < 0) return;
  sortColumn_ = static_cast<NodeColumn>(column);
  sortOrder_ = order;
  list();
}

/// Rows that are the same stay: what is selected, scrolled to or typed there does as well.
void NodeTableModel::list() {
  const Skeleton& skeleton = facts_.document().skeleton();
  std::vector<NodeId> rows = nodes_ ? *nodes_ : skeleton.ids();
  std::erase_if(rows,
                [&](NodeId id) { return !skeleton.contains(id) || !filter_.accepts(facts_, id); });
  sortRows(rows);
  if (rows == rows_) return refreshCells();
  beginResetModel();
  rows_ = std::move(rows);
  rowOf_.assign(skeleton.idEnd(), -1);
  for (std::size_t row = 0; row < rows_.size(); ++row)
    rowOf_[indexOf(rows_[row])] = static_cast<int>(row);
  endResetModel();
}

/// Equal cells in order of the nodes; empty ones last, up or down.
void NodeTableModel::sortRows(std::vector<NodeId>& rows) const {
  std::ranges::sort(rows);
  if (sortColumn_ == NodeColumn::node) {
    if (sortOrder_ == Qt::DescendingOrder) std::ranges::reverse(rows);
    return;
  }
  struct Key {
    bool isEmpty;
    double number;
    QString text;
    NodeId id;
  };
  std::vector<Key> keys;
  keys.reserve(rows.size());
  for (const NodeId id : rows) {
    const std::optional<double> number = facts_.number(id, sortColumn_);
    const QString text = isNumber(sortColumn_) ? QString() : facts_.text(id, sortColumn_);
    keys.push_back({!number && text.isEmpty(), number.value_or(0), text, id});
  }
  const bool isDown = sortOrder_ == Qt::DescendingOrder;
  std::ranges::stable_sort(keys, [isDown](const Key& a, const Key& b) {
    if (a.isEmpty != b.isEmpty) return b.isEmpty;
    const Key& low = isDown ? b : a;
    const Key& high = isDown ? a : b;
    return low.number != high.number ? low.number < high.number : low.text < high.text;
  });
  std::ranges::transform(keys, rows.begin(), &Key::id);
}

/// As read at a glance: 5 digits of a length.
QString NodeTableModel::cellText(NodeId id, NodeColumn column) const {
  if (!isLength(column)) return facts_.text(id, column);
  const std::optional<double> value = facts_.number(id, column);
  return value ? formatLength(*value, LengthUnit::unknown, 5) : QString();
}

QString NodeTableModel::headerText(NodeColumn column, const QString& name) const {
  const QString unit = symbol(facts_.document().unit());
  return isLength(column) && !unit.isEmpty() ? QStringLiteral("%1 [%2]").arg(name, unit) : name;
}

} // namespace espalier
