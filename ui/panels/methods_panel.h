#pragma once

#include "core/evaluate/evaluation.h"
#include "ui/document/length_unit.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;

namespace espalier {

/// The scores of one structure against the reference.
struct MethodScores {
  double nodes = 0;
  double f = 0, precision = 0, recall = 0; // within the tolerance
  double tips = 0, branchings = 0;         // F
  double toReference = 0, toResult = 0;    // [L], mean distances
  double mapping = 0, geometric = 0, cappedGeometric = 0, structural = 0, structuralOfAll = 0;
  double types = 0;            // kappa
  std::optional<double> edits; // none: too many parts
  double wrong = 0;            // attachments
  double shift = 0;            // [L]

  [[nodiscard]] static MethodScores of(const Evaluation& evaluation);
};

/// A structure in the table, and where it stands.
struct MethodRow {
  QString name;
  std::optional<MethodScores> scores; // none: not compared yet
  QString error;                      // why it cannot be; empty: nothing is known against it
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

  QLabel* note_;
  QPushButton* add_;
  QPushButton* remove_;
  QPushButton* copy_;
  QTableWidget* table_;
  QString noteText_;
};

} // namespace espalier
