#pragma once

#include "core/pipeline/option_table.h"
#include "core/pipeline/typed_value.h"

#include <QDoubleSpinBox>

#include <optional>

namespace espalier {

/// A field for a number, which may be typed with a unit as on the command line: see typedValue().
/// Where its suffix is a unit of length, "3 cm" where lengths are in m becomes "0.03 m"; where the
/// plant has a scale, "6 sp" becomes the length that 6 spacings are. A comma typed for the point is
/// taken; what is shown has the point whatever the system writes, as all numbers of the window do,
/// and all files.
///
/// What is beyond the range becomes its nearest end once the typing is over. A letter that no
/// number has is not taken, and a tip below the field says what is.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

public:
  explicit NumberBox(QWidget* parent = nullptr);

  [[nodiscard]] QValidator::State validate(QString& text, int& cursor) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  void fixup(QString& text) const override;
  [[nodiscard]] QString textFromValue(double value) const override;
  /// What may be typed here, in words.
  [[nodiscard]] QString taken() const;

  /// Of a length that may be typed in spacings of the points and heights of the plant.
  void setScale(const PlantScale& scale) { scale_ = scale; }
  /// How many digits there is room for: a value of more digits before its point shows fewer after
  /// it, where it has none but zeros there. 0, as at first: as many as decimals() says.
  void setMostDigits(int digits) { mostDigits_ = digits; }
  /// How many digits a value has after its point here.
  [[nodiscard]] int decimalsOf(double value) const;

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  struct Typed {
    QValidator::State state;
    std::optional<double> value; // in the unit of the field; none: not complete
  };
  [[nodiscard]] Typed read(const QString& text) const;
  [[nodiscard]] std::optional<double> factorOf(ValueUnit unit) const;

  std::optional<PlantScale> scale_;
  int mostDigits_ = 0;
};

} // namespace espalier
