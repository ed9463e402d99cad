#pragma once

#include "core/project/seal.h"
#include "ui/document/length_unit.h"

#include <QDialog>

class QLineEdit;

namespace espalier {

/// Shows what is about to be signed, and asks who signs it.
class SignDialog : public QDialog {
  Q_OBJECT

public:
  /// @param draft  the seal as it would be, whoever signs
  SignDialog(const Seal& draft, LengthUnit unit, const QString& signer, QWidget* parent = nullptr);

  [[nodiscard]] QString signer() const; // not blank once it is accepted

private:
  QLineEdit* signer_;
};

} // namespace espalier
