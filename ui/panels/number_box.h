#pragma once

#include <QDoubleSpinBox>

#include <optional>

namespace espalier {

/// A field for a number. Where its suffix is a unit of length, numbers may be typed in any other:
/// "3 cm" where lengths are in m becomes "0.03 m". Digits may stand after a point or a comma.
///
/// What is beyond the range becomes its nearest end once the typing is over. A letter that no
/// number has is not taken, and a tip below the field tells what is.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

public:
  using QDoubleSpinBox::QDoubleSpinBox;

  [[nodiscard]] QValidator::State validate(QString& text, int& cursor) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  void fixup(QString& text) const override;
  /// What may be typed here, in words.
  [[nodiscard]] QString taken() const;

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  struct Typed {
    QValidator::State state;
    std::optional<double> value; // in the unit of the field; none: not complete
  };
  [[nodiscard]] Typed read(const QString& text) const;
};

} // namespace espalier
