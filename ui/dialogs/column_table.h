#pragma once

#include "core/io/points/first_lines.h"

#include <QTableWidget>

#include <vector>

class QComboBox;

namespace espalier {

class ColumnHeader;

/// How a text file begins, with a list above each column that says what it holds. Lines that are no
/// point with these columns are marked.
class ColumnTable : public QTableWidget {
  Q_OBJECT

public:
  explicit ColumnTable(FirstLines text, const std::vector<PointField>& chosen,
                       QWidget* parent = nullptr);

  [[nodiscard]] std::vector<PointField> fields() const;
  [[nodiscard]] const std::vector<QComboBox*>& lists() const;
  /// Why the file cannot be read with these columns, in a sentence; empty: it can, as far as shown.
  [[nodiscard]] QString problem() const;

signals:
  void fieldsChanged();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override; // a list that gets the focus is shown
  void scrollContentsBy(int dx, int dy) override;

private:
  void fill();
  void mark();
  [[nodiscard]] bool isWrong(const TextLine& line) const;
  [[nodiscard]] QString problemOfLine(const TextLine& line) const;

  FirstLines text_;
  ColumnHeader* header_;
};

} // namespace espalier
