#pragma once

#include "core/pipeline/option_table.h"

#include <QObject>
#include <QString>

#include <optional>

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace espalier {

class OptionSlider;

/// One option of a method in a form: name, slider, number with unit, and the way back to the
/// default. All of it is made from the option table.
class OptionField : public QObject {
  Q_OBJECT

public:
  /// Adds its widgets to the next rows of `grid`, which has two columns.
  OptionField(const Option& option, QGridLayout& grid, QWidget& parent);

  /// What the default and the range are, for this plant.
  void setScale(const PlantScale& scale, const QString& unit);

  /// What the user chose; none while it is the default.
  [[nodiscard]] std::optional<double> chosen() const { return chosen_; }
  void choose(std::optional<double> value);

signals:
  void changed();

private:
  [[nodiscard]] double value() const;
  [[nodiscard]] double placeOf(double value) const; // on the slider, in [0, 1]
  [[nodiscard]] double valueAt(double place) const;
  void showValue();

  Option option_;
  PlantScale scale_{.spacing = 1, .height = 100};
  std::optional<double> chosen_;
  QLabel* label_;
  OptionSlider* slider_;
  QDoubleSpinBox* number_;
  QToolButton* reset_;
};

} // namespace espalier
