#pragma once

#include "ui/panels/node_facts.h"
#include "ui/panels/node_filter.h"

#include <QAbstractTableModel>

#include <optional>
#include <vector>

namespace espalier {

/// Nodes of a document as rows, filtered and sorted. A cell is read when it is shown.
class NodeTableModel : public QAbstractTableModel {
  Q_OBJECT

public:
  /// @param document must outlive it
  explicit NodeTableModel(const PlantDocument& document, QObject* parent = nullptr);

  /// Lists these nodes, or all; those that are gone are left out. O(N + M log M) for M rows.
  void show(std::optional<std::vector<NodeId>> nodes);
  void setFilter(NodeFilter filter); // likewise
  /// Reads all again, after an edit. O(N + M log M).
  void update();
  /// The same cells may have other values.
  void refreshCells();

  [[nodiscard]] NodeId node(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] std::optional<int> row(NodeId id) const;
  /// Rows as lines of cells parted by tabs, headed by the names with the unit of lengths. Numbers
  /// to all digits, with a decimal point.
  [[nodiscard]] QString tableOf(const std::vector<NodeId>& nodes) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Changes nothing itself: reports what was typed.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  void sort(int column, Qt::SortOrder order) override;

signals:
  void radiusTyped(espalier::NodeId id, double radius); // >= 0 [L]
  void edgeChosen(espalier::NodeId id, espalier::EdgeType type);
  void refused(const QString& reason); // of what was typed

private:
  void list();
  void sortRows(std::vector<NodeId>& rows) const;
  [[nodiscard]] QString cellText(NodeId id, NodeColumn column) const;
  [[nodiscard]] QString headerText(NodeColumn column, const QString& name) const;

  NodeFacts facts_;
  NodeFilter filter_;
  std::optional<std::vector<NodeId>> nodes_; // none: all
  std::vector<NodeId> rows_;
  std::vector<int> rowOf_; // by id; -1: none
  NodeColumn sortColumn_ = NodeColumn::node;
  Qt::SortOrder sortOrder_ = Qt::AscendingOrder;
};

} // namespace espalier
