#pragma once

#include "ui/panels/option_field.h"

class QCheckBox;
class QComboBox;

namespace espalier {

/// An option that is one of several words: a list to choose from.
class ChoiceField : public OptionField {
  Q_OBJECT

public:
  ChoiceField(const Option& option, QGridLayout& grid, QWidget& parent);

private:
  void showScale(const QString& unit) override;
  void showValue() override;

  QComboBox* words_;
};

/// An option that is on or off: a box to check.
class FlagField : public OptionField {
  Q_OBJECT

public:
  FlagField(const Option& option, QGridLayout& grid, QWidget& parent);

private:
  void showScale(const QString& unit) override;
  void showValue() override;

  QCheckBox* box_;
};

} // namespace espalier
