#pragma once

#include "core/evaluate/scores.h"

#include <QString>
#include <QTableWidget>

#include <optional>
#include <vector>

namespace espalier {

/// A number that states are judged by.
struct JudgeRow {
  QString name;
  QString unit;    // empty: none
  QString meaning; // how it is defined, for its tip
  Better better = Better::neither;
  int decimals = 2;
  std::vector<std::optional<double>> values; // one per state; none: not known
};

/// Numbers of a few states of a plant side by side, each with its difference to the first state, as
/// they are written: small and quiet, with a mark where it is better or worse. Copying takes the
/// table, for a spreadsheet.
class JudgeTable : public QTableWidget {
  Q_OBJECT

public:
  explicit JudgeTable(QWidget* parent = nullptr);

  /// @param states their names: "Plant", "A", "Preview"
  /// @param areOfSame points; if not, their numbers have no differences
  void show(const QStringList& states, const std::vector<JudgeRow>& rows, bool areOfSame = true);
  [[nodiscard]] int heightForRows() const; // to see all of them [px]
  /// The table for a spreadsheet: columns divided by tabs, numbers in full.
  [[nodiscard]] QString table() const;

private:
  void fillRow(int place, const JudgeRow& row);

  QStringList states_;
  bool areOfSame_ = true;
  std::vector<JudgeRow> rows_;
};

} // namespace espalier
