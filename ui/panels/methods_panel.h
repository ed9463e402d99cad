#pragma once

#include "ui/document/length_unit.h"
#include "ui/panels/score_text.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QPushButton;
class QTableWidget;

namespace espalier {

class ElidedLabel;

/// A structure in the table, and where it stands.
struct MethodRow {
  QString name;
  std::optional<ScoreValues> scores; // none: not compared yet
  QString error;                     // why it cannot be, or what is doubtful; empty: all is well
};

/// A table of any number of structures against one reference: a row each, sorted by any column.
class MethodsPanel : public QWidget {
  Q_OBJECT

public:
  explicit MethodsPanel(QWidget* parent = nullptr);

  /// @param reference its name; empty: there is none
  /// @param tolerance [L], what is called near; 0: not known yet
  void show(const std::vector<MethodRow>& rows, const QString& reference, LengthUnit unit,
            double tolerance = 0);
  void setBusy(bool isBusy);
  /// The table as it is sorted, for a spreadsheet: columns divided by tabs, numbers in full.
  [[nodiscard]] QString table() const;

signals:
  void addRequested();
  void removeRequested(const std::vector<int>& rows); // as they were shown
  void copyRequested();

private:
  [[nodiscard]] std::vector<int> chosenRows() const;

  ElidedLabel* note_;
  QPushButton* add_;
  QPushButton* remove_;
  QPushButton* copy_;
  QTableWidget* table_;
  QString noteText_;
};

} // namespace espalier
