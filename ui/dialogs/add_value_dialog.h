#pragma once

#include "core/mtg/feature_edits.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace espalier {

/// Asks for a value of a feature: of a new one, with its name and type, or of one of those known.
class AddValueDialog : public QDialog {
  Q_OBJECT

public:
  /// @param known  features to choose from; empty: a new one is typed
  AddValueDialog(const QString& title, std::vector<MtgFeature> known, QWidget* parent = nullptr);

  [[nodiscard]] QWidget* nameField() const;
  [[nodiscard]] QWidget* valueField() const;

signals:
  /// It is to be done. The dialog stays open, in case that it is refused.
  void addRequested(const espalier::TypedFeature& typed);

private:
  void addTypes();
  void addKnown();
  [[nodiscard]] MtgFeature feature() const;
  void refresh();

  std::vector<MtgFeature> known_;
  QLineEdit* name_; // of a new feature
  QComboBox* type_; // of it, or one of those known
  QLineEdit* value_;
  QPushButton* add_;
};

} // namespace espalier
