#pragma once

#include "core/project/seal.h"
#include "ui/document/length_unit.h"

#include <QDialog>

class QLineEdit;

namespace espalier {

/// Asks for the name under which a structure is signed, beside what the seal will say, and why it
/// is signed where findings are open.
class SignDialog : public QDialog {
  Q_OBJECT

public:
  /// @param draft the seal as it would be; its author, time and reason are not shown
  SignDialog(const Seal& draft, LengthUnit unit, const QString& signer, QWidget* parent = nullptr);

  [[nodiscard]] QString signer() const; // not blank once accepted
  [[nodiscard]] QString reason() const; // likewise, where findings are open

private:
  QLineEdit* signer_;
  QLineEdit* reason_;
};

} // namespace espalier
