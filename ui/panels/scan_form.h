#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace espalier {

class PlantDocument;

/// What the scan is: its file, points and size; and what can be chosen of it before anything is
/// made of it: the unit of its coordinates, which of its axes points up, and where the root is.
class ScanForm : public QWidget {
  Q_OBJECT

public:
  explicit ScanForm(PlantDocument& document, QWidget* parent = nullptr);

signals:
  void rootAsked(); // it is to be picked in the view

private:
  void refresh();
  void refreshUp();
  void refreshRoot();
  void chooseRoot();

  PlantDocument& document_;
  QLabel* name_;
  QLabel* points_;
  QLabel* size_;
  QComboBox* unit_;
  QComboBox* up_;
  QComboBox* root_;
};

} // namespace espalier
