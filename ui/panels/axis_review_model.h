#pragma once

#include "core/skeleton/review_coverage.h"
#include "ui/document/length_unit.h"

#include <QAbstractTableModel>

#include <vector>

namespace espalier {

/// The axes of a plant in the order of the review walk, with how much of each is reviewed.
class AxisReviewModel : public QAbstractTableModel {
  Q_OBJECT

public:
  using QAbstractTableModel::QAbstractTableModel;

  void show(const Skeleton& skeleton, LengthUnit unit); // O(N)
  [[nodiscard]] const Axis& axis(int row) const { return rows_[std::size_t(row)].axis; }

  [[nodiscard]] QString longestName() const; // of an axis, at most

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

private:
  static constexpr int deepest = 3; // what is of a higher order is indented no farther
  static QString name(int row, int order);
  struct Row {
    Axis axis;
    int order = 0;
    ReviewCoverage seen;
  };
  std::vector<Row> rows_;
  LengthUnit unit_ = LengthUnit::unknown;
};

} // namespace espalier
