#pragma once

#include "core/mtg/structure.h"

#include <QAbstractItemModel>
#include <QStringList>

#include <memory>
#include <vector>

namespace espalier {

/// The vertices of an MTG as a tree: the parts of a vertex below it, in the order of the file.
/// Their labels, what they are attached to, and their features; values of later dates in rows of
/// their own, first below their vertex. A cell is read when it is shown.
class VertexModel : public QAbstractItemModel {
  Q_OBJECT

public:
  using QAbstractItemModel::QAbstractItemModel;

  void show(std::shared_ptr<const MtgFrame> frame); // null: none

  [[nodiscard]] QModelIndex index(int row, int column,
                                  const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

private:
  /// Of a vertex, and of a date of it: 0 for the vertex itself, 1 for its first later date.
  struct Row {
    std::uint32_t vertex = 0;
    std::uint32_t date = 0;
  };
  [[nodiscard]] static Row rowOf(const QModelIndex& index);
  [[nodiscard]] const MtgVertex& vertex(Row row) const;
  [[nodiscard]] const std::vector<VertexId>& partsOf(const QModelIndex& parent) const;
  [[nodiscard]] QString text(Row row, int column) const;

  std::shared_ptr<const MtgFrame> frame_;
  std::vector<std::vector<VertexId>> parts_; // by vertex; those of none last
  std::vector<int> places_;                  // by vertex: among the parts of what it is a part of
};

} // namespace espalier
