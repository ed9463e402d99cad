#pragma once

#include "ui/dialogs/scan_look.h"

#include <QDialog>

#include <cstdint>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace espalier {

class ColumnTable;
class CountBox;
class PartForm;

/// What a scan is before it is read, and how it is to be read: what its columns hold, unit and up
/// axis, and how much of it.
class ScanDialog : public QDialog {
  Q_OBJECT

public:
  /// @param mostAtOnce  scans of up to so many points are read without asking
  ScanDialog(ScanLook look, std::uint64_t mostAtOnce, QWidget* parent = nullptr);

  [[nodiscard]] ScanChoices choices() const;
  [[nodiscard]] std::vector<PointField> columns() const; // of a text file; empty: of another
  [[nodiscard]] std::uint64_t mostAtOnce() const;
  [[nodiscard]] bool remembersColumns() const; // for files that begin alike

  /// What was found out with the columns that were chosen last.
  void setGlance(const PointGlance& glance);
  [[nodiscard]] const PointGlance& glance() const { return look_.glance; }
  void showProblem(const QString& problem); // why that failed

signals:
  void columnsChosen(const std::vector<espalier::PointField>& columns); // complete ones

private:
  [[nodiscard]] QVBoxLayout* makeHead();
  [[nodiscard]] QFormLayout* makeForm();
  void makeTable(QVBoxLayout& page);
  void makeEnd(QVBoxLayout& page);
  void orderTabs();
  void showChosen();
  void showGlance();
  void showQuestions();
  void refreshColumns();
  void refresh();
  [[nodiscard]] LengthUnit unit() const;

  ScanLook look_;
  std::uint64_t asked_; // mostAtOnce when it opened
  QLabel* questions_;
  QLabel* points_;
  QLabel* columns_;
  QLabel* bounds_;
  QLabel* size_;
  QComboBox* unit_;
  QLabel* unitReason_;
  QComboBox* up_;
  QLabel* upReason_;
  PartForm* part_;
  ColumnTable* table_ = nullptr; // null: no text file
  QCheckBox* remembers_;
  CountBox* limit_;
  QLabel* problem_;
  QPushButton* open_ = nullptr;
  QPushButton* cancel_ = nullptr;
  bool isUnitChosen_ = false; // by hand: it stays
  bool isUpChosen_ = false;   // likewise
  bool areColumnsChosen_ = false;
};

} // namespace espalier
