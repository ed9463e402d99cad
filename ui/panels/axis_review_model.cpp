#include "ui/panels/axis_review_model.h"

#include "core/skeleton/review_walk.h"
#include "ui/panels/coverage_text.h"

#include <algorithm>

namespace espalier {
namespace {

enum AxisColumn { axisName, axisLength, axisState, axisColumns };

/// A tick for all.
QString stateText(const ReviewCoverage& seen) {
  if (seen.isComplete()) return QStringLiteral("✓");
  return QStringLiteral("%1%2 %").arg(seen.state() == ReviewState::doubtful ? "? " : "",
                                      percentText(seen, ReviewState::reviewed, 0));
}

/// All that is not reviewed yet.
QString leftText(const ReviewCoverage& seen) {
  if (seen.isComplete()) return AxisReviewModel::tr("reviewed");
  const auto nodes = [&](ReviewState state) { return seen.nodes[static_cast<std::size_t>(state)]; };
  QStringList left;
  if (nodes(ReviewState::doubtful) > 0)
    left.append(AxisReviewModel::tr("%1 doubtful").arg(nodesText(nodes(ReviewState::doubtful))));
  if (nodes(ReviewState::toDo) > 0)
    left.append(AxisReviewModel::tr("%1 to do").arg(nodesText(nodes(ReviewState::toDo))));
  return left.join(QStringLiteral(", "));
}

} // namespace

QString AxisReviewModel::name(int row, int order) {
  return QString(std::min(order, deepest), ' ') + QString::number(row + 1);
}

QString AxisReviewModel::longestName() const {
  return name(rowCount(), deepest);
}

void AxisReviewModel::show(const Skeleton& skeleton, LengthUnit unit) {
  std::vector<Row> rows;
  const std::vector<int> orderOf = orders(skeleton);
  for (Axis& axis : axesInWalkOrder(skeleton)) {
    Row row{.order = orderOf[indexOf(axis.front())], .seen = coverage(skeleton, axis)};
    row.axis = std::move(axis);
    rows.push_back(std::move(row));
  }
  unit_ = unit;
  if (rows.size() == rows_.size()) { // where one is in the list stays
    rows_ = std::move(rows);
    if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, axisColumns - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int AxisReviewModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int AxisReviewModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : axisColumns;
}

QVariant AxisReviewModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {}; // Ctrl+C where no row is current
  const Row& row = rows_[std::size_t(index.row())];
  if (role == Qt::ToolTipRole)
    return tr("Axis %1 of order %2, from node %3: %4")
        .arg(index.row() + 1)
        .arg(row.order)
        .arg(indexOf(row.axis.front()))
        .arg(leftText(row.seen));
  if (role == Qt::TextAlignmentRole && index.column() != axisName)
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
  case axisName:
    return name(index.row(), row.order);
  case axisLength:
    return formatLength(row.seen.totalLength(), unit_, 3);
  default:
    return stateText(row.seen);
  }
}

QVariant AxisReviewModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role == Qt::TextAlignmentRole)
    return QVariant((section == axisName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
  case axisName:
    return tr("Axis");
  case axisLength:
    return tr("Length");
  default:
    return tr("Done");
  }
}

} // namespace espalier
