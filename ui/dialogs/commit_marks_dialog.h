#pragma once

#include "core/mtg/unit_scales.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace espalier {

class PlantDocument;

/// Asks for the class of the units that marks become, and where their scale goes.
class CommitMarksDialog : public QDialog {
  Q_OBJECT

public:
  explicit CommitMarksDialog(PlantDocument& document, QWidget* parent = nullptr);

  [[nodiscard]] QWidget* symbolField() const;

signals:
  /// It is to be done. The dialog stays open, in case that it is refused.
  void commitRequested(const espalier::NewScale& scale);

private:
  void addPlaces();
  void refresh();

  PlantDocument& document_;
  QLineEdit* symbol_;
  QComboBox* place_;
  QLabel* outcome_;
  QPushButton* commit_;
};

} // namespace espalier
