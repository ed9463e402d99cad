#include "ui/panels/history_model.h"

#include "ui/document/plant_document.h"
#include "ui/document/time_text.h"

#include <QApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QFont>
#include <QLocale>
#include <QPalette>

#include <algorithm>

namespace espalier {

HistoryModel::HistoryModel(PlantDocument& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, &HistoryModel::follow);
  connect(&document, &PlantDocument::skeletonReplaced, this, &HistoryModel::follow);
  follow();
}

int HistoryModel::positionOf(int row) const {
  if (!hasGap() || row <= opened_) return row;
  return row == opened_ + 1 ? -1 : row - 1;
}

int HistoryModel::currentRow() const {
  return rowOf(std::min(document_.undoStack().index(), steps_));
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : 1 + steps_ + (hasGap() ? 1 : 0);
}

int HistoryModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {}; // Ctrl+C where no row is current
  const int position = positionOf(index.row());
  const int present = document_.undoStack().index();
  if (position > document_.undoStack().count()) return {}; // dropped just now
  switch (role) {
  case Qt::DisplayRole:
    break;
  case Qt::ForegroundRole:
    if (position >= 0 && position <= present) return {};
    return QApplication::palette().color(QPalette::PlaceholderText);
  case Qt::FontRole: {
    QFont font;
    font.setBold(position == present);
    font.setItalic(position < 0);
    return font;
  }
  case Qt::ToolTipRole:
    return position <= 0 ? textOf(position)
                         : tr("%1, %2").arg(textOf(position), timeOf(position, true));
  default:
    return {};
  }
  switch (index.column()) {
  case markColumn:
    return position == present ? QStringLiteral("▸") : QString();
  case textColumn:
    return textOf(position);
  case timeColumn:
    return position > 0 ? timeOf(position, false) : QString();
  default:
    return position > 0 ? QString::fromStdString(document_.step(position - 1).author) : QString();
  }
}

QVariant HistoryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
  case textColumn:
    return tr("Step");
  case timeColumn:
    return tr("Time");
  case authorColumn:
    return tr("Author");
  default:
    return QString();
  }
}

Qt::ItemFlags HistoryModel::flags(const QModelIndex& index) const {
  if (positionOf(index.row()) < 0) return Qt::ItemNeverHasChildren;
  return QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
}

/// As many rows come or go as steps do. A gap elsewhere is rare: then all is read again.
void HistoryModel::follow() {
  const int steps = document_.undoStack().count();
  const int opened = document_.openedSteps();
  if (opened != opened_ || steps < steps_) {
    beginResetModel();
    steps_ = steps;
    opened_ = opened;
    endResetModel();
  } else if (steps > steps_) {
    beginInsertRows({}, rowCount(), rowCount() + steps - steps_ - 1);
    steps_ = steps;
    endInsertRows();
  }
  emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
}

int HistoryModel::rowOf(int position) const {
  return hasGap() && position > opened_ ? position + 1 : position;
}

QString HistoryModel::textOf(int position) const {
  const QString file = QFileInfo(document_.filePath()).fileName();
  if (position < 0) return tr("Opened here");
  if (position > 0) return QString::fromStdString(document_.step(position - 1).text);
  if (opened_ > 0 || file.isEmpty()) return tr("The beginning");
  return tr("Opened %1").arg(file);
}

/// Those of another day with their date; whole: with the year as well.
QString HistoryModel::timeOf(int position, bool isWhole) const {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(document_.step(position - 1).time);
  if (isWhole) return QLocale().toString(time, QLocale::LongFormat);
  if (time.date() == QDate::currentDate()) return time.toString(QStringLiteral("HH:mm:ss"));
  return momentText(time);
}

} // namespace espalier
