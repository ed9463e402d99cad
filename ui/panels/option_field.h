#pragma once

#include "core/pipeline/option_table.h"

#include <QObject>
#include <QString>

#include <optional>

class QGridLayout;
class QLabel;
class QToolButton;

namespace espalier {

/// One option of a method in a form: its name, what it is set with, and a button back to the
/// default. All of it is made from the option table.
class OptionField : public QObject {
  Q_OBJECT

public:
  /// The field for the kind of `option`: its widgets are added to the next rows of `grid`, which
  /// has two columns. Owned by `parent`.
  [[nodiscard]] static OptionField* make(const Option& option, QGridLayout& grid, QWidget& parent);

  /// What the default and the range are, for this plant. What was chosen stays, and is marked where
  /// it is out of the range.
  void setScale(const PlantScale& scale, const QString& unit);

  /// What the user chose; none while it is the default.
  [[nodiscard]] const std::optional<Rule>& chosen() const { return chosen_; }
  void choose(const std::optional<Rule>& value);
  void choose(double value) { choose(fixedAt(value)); }

  [[nodiscard]] const Option& option() const { return option_; }
  /// What it stands at for this plant, chosen or by default.
  [[nodiscard]] double value() const { return chosen_.value_or(option_.rule).value(scale_); }

signals:
  void changed();

protected:
  OptionField(const Option& option, QWidget& parent);

  [[nodiscard]] const PlantScale& scale() const { return scale_; }
  [[nodiscard]] QLabel& label() const { return *label_; }
  /// `text` and the button for the default, across the grid: a long text widens no other field.
  void addHead(QGridLayout& grid, int row, QWidget& text) const;
  [[nodiscard]] QString help() const; // for tips

  virtual void showScale(const QString& unit) = 0; // range and tips
  virtual void showValue() = 0;
  /// What it may stand at, where it stands at something else: as "0.01 to 0.3 m".
  [[nodiscard]] virtual std::optional<QString> allowed() const { return std::nullopt; }

private:
  void show();

  Option option_;
  PlantScale scale_{.spacing = 1, .height = 100};
  std::optional<Rule> chosen_;
  QLabel* label_;
  QToolButton* reset_;
};

} // namespace espalier
