#pragma once

#include <QAbstractTableModel>

namespace espalier {

class PlantDocument;

/// The steps of a document, the first at the top, in rows: how it was opened, then each step, with
/// a gap behind those that came with the file. Reads the document as it goes: it copies nothing.
class HistoryModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { markColumn, textColumn, timeColumn, authorColumn, columns };

  /// @param document must outlive it
  explicit HistoryModel(PlantDocument& document, QObject* parent = nullptr);

  /// How many steps are done in the state that a row stands for; -1 for the gap.
  [[nodiscard]] int positionOf(int row) const;
  [[nodiscard]] int currentRow() const; // of the present state

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
  void follow();
  [[nodiscard]] int rowOf(int position) const;
  [[nodiscard]] bool hasGap() const { return opened_ > 0; }
  [[nodiscard]] QString textOf(int position) const;
  [[nodiscard]] QString timeOf(int position, bool isWhole) const;

  PlantDocument& document_;
  int steps_ = 0;  // as the views know them
  int opened_ = 0; // those of them that came with the file
};

} // namespace espalier
