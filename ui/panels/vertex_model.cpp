#include "ui/panels/vertex_model.h"

#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_values.h"

namespace espalier {
namespace {

enum VertexColumn { vertexColumn, scaleColumn, attachedColumn, ownColumns };

constexpr int dateBits = 24;

} // namespace

void VertexModel::show(std::shared_ptr<const MtgFrame> frame) {
  beginResetModel();
  frame_ = std::move(frame);
  const std::size_t vertices = frame_ ? frame_->mtg.vertices.size() : 0;
  parts_.assign(vertices + 1, {});
  places_.assign(vertices, 0);
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto complex = frame_->mtg.vertices[i].complex;
    std::vector<VertexId>& parts = parts_[complex ? indexOf(*complex) : vertices];
    places_[i] = static_cast<int>(parts.size());
    parts.push_back(VertexId{static_cast<std::uint32_t>(i)});
  }
  endResetModel();
}

VertexModel::Row VertexModel::rowOf(const QModelIndex& index) {
  const quint64 id = index.internalId();
  return {static_cast<std::uint32_t>(id >> dateBits),
          static_cast<std::uint32_t>(id & ((quint64{1} << dateBits) - 1))};
}

const MtgVertex& VertexModel::vertex(Row row) const {
  return frame_->mtg.vertices[row.vertex];
}

const std::vector<VertexId>& VertexModel::partsOf(const QModelIndex& parent) const {
  return parent.isValid() ? parts_[rowOf(parent).vertex] : parts_.back();
}

QModelIndex VertexModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  const int dates = parent.isValid() ? static_cast<int>(vertex(rowOf(parent)).later.size()) : 0;
  if (row < dates)
    return createIndex(row, column,
                       (quint64{rowOf(parent).vertex} << dateBits) + std::uint32_t(row) + 1);
  const VertexId part = partsOf(parent)[static_cast<std::size_t>(row - dates)];
  return createIndex(row, column, quint64{indexOf(part)} << dateBits);
}

QModelIndex VertexModel::parent(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const Row row = rowOf(index);
  std::optional<VertexId> above = vertex(row).complex;
  if (row.date > 0) above = VertexId{row.vertex};
  if (!above) return {};
  const auto complex = vertex({static_cast<std::uint32_t>(*above)}).complex;
  const int dates =
      complex ? static_cast<int>(frame_->mtg.vertices[indexOf(*complex)].later.size()) : 0;
  return createIndex(places_[indexOf(*above)] + dates, 0, quint64{indexOf(*above)} << dateBits);
}

int VertexModel::rowCount(const QModelIndex& parent) const {
  if (!frame_ || parent.column() > 0) return 0;
  if (!parent.isValid()) return static_cast<int>(parts_.back().size());
  if (rowOf(parent).date > 0) return 0;
  return static_cast<int>(partsOf(parent).size() + vertex(rowOf(parent)).later.size());
}

int VertexModel::columnCount(const QModelIndex& /*parent*/) const {
  return frame_ ? ownColumns + static_cast<int>(frame_->mtg.features.size()) : 0;
}

QVariant VertexModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const int feature = index.column() - ownColumns;
  if (role == Qt::TextAlignmentRole && feature >= 0 &&
      isNumberFeature(frame_->mtg.features[static_cast<std::size_t>(feature)]))
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  return role == Qt::DisplayRole ? QVariant(text(rowOf(index), index.column())) : QVariant();
}

QString VertexModel::text(Row row, int column) const {
  const MtgVertex& of = vertex(row);
  if (column >= ownColumns) {
    const auto feature = static_cast<std::size_t>(column - ownColumns);
    const std::vector<std::string>& values = row.date > 0 ? of.later[row.date - 1] : of.values;
    if (row.date == 0 && isAliasFeature(frame_->mtg.features[feature]))
      return QString::fromStdString(of.alias);
    return feature < values.size() ? QString::fromStdString(values[feature]) : QString();
  }
  if (row.date > 0)
    return column == vertexColumn ? tr("at later date %1").arg(row.date) : QString();
  if (column == scaleColumn) return QString::number(of.scale);
  if (column == vertexColumn) return QString::fromStdString(mtgLabel(of));
  if (!of.parent) return {};
  return QLatin1Char(static_cast<char>(of.edge)) + QStringLiteral(" ") +
         QString::fromStdString(mtgLabel(frame_->mtg.vertices[indexOf(*of.parent)]));
}

QVariant VertexModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (!frame_ || orientation != Qt::Horizontal) return {};
  if (section >= ownColumns) {
    const MtgFeature& feature =
        frame_->mtg.features[static_cast<std::size_t>(section - ownColumns)];
    if (role == Qt::DisplayRole) return QString::fromStdString(feature.name);
    return role == Qt::ToolTipRole ? tr("Of type %1").arg(QString::fromStdString(feature.type))
                                   : QVariant();
  }
  if (role == Qt::ToolTipRole && section == attachedColumn)
    return tr("The vertex that carries it: < it follows that, + it branches off");
  if (role != Qt::DisplayRole) return {};
  return QStringList{tr("Vertex"), tr("Scale"), tr("Attached to")}[section];
}

} // namespace espalier
