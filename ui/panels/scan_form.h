#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace espalier {

class PlantDocument;

/// What the scan is: its file, points, size, and the unit of its coordinates, which can be chosen.
class ScanForm : public QWidget {
  Q_OBJECT

public:
  explicit ScanForm(PlantDocument& document, QWidget* parent = nullptr);

private:
  void refresh();

  PlantDocument& document_;
  QLabel* name_;
  QLabel* points_;
  QLabel* size_;
  QComboBox* unit_;
};

} // namespace espalier
