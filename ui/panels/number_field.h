#pragma once

#include "ui/panels/option_field.h"

class QDoubleSpinBox;

namespace espalier {

class NumberBox;
class OptionSlider;

/// Gives a field the range, the digits and the unit of an option.
void dress(QDoubleSpinBox& number, const Option& option, const PlantScale& scale,
           const QString& unit);

/// An option that is a number: a slider, and the number with its unit.
class NumberField : public OptionField {
  Q_OBJECT

public:
  NumberField(const Option& option, QGridLayout& grid, QWidget& parent);

  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void showScale(const QString& unit) override;
  void showValue() override;
  [[nodiscard]] std::optional<QString> allowed() const override;
  [[nodiscard]] bool isInRange() const;
  [[nodiscard]] bool isBrokenCount() const; // as settings may give it: 3.5
  /// What was typed as "6 sp": it stays a rule, which holds for other scans, too. Once.
  [[nodiscard]] std::optional<Rule> takeTypedRule();
  [[nodiscard]] double placeOf(double value) const; // on the slider, in [0, 1]
  [[nodiscard]] double valueAt(double place) const;

  OptionSlider* slider_;
  NumberBox* number_;
  QString typed_; // by hand since the number changed
};

} // namespace espalier
