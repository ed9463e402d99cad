#pragma once

#include <QFrame>
#include <QString>

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace espalier {

class OptionSlider;

/// A bar over the view: from what distance to the skeleton on points stay bright, and whether the
/// others are dimmed or hidden. The distance is set by the sensitivity of the checks.
class ExplainedBar : public QFrame {
  Q_OBJECT

public:
  explicit ExplainedBar(QWidget* parent = nullptr);

  /// @param usual       distance at the usual sensitivity [L], > 0
  /// @param sensitivity of the checks, by which it is divided
  void setLimits(double usual, double sensitivity, const QString& unit);

  [[nodiscard]] double distance() const { return usual_ / sensitivity_; } // [L]
  [[nodiscard]] bool isHiding() const;                                    // else dimming
  void setHiding(bool isHiding);
  void showLeft(const QString& text); // how much is left

signals:
  void changed();                             // the distance, or whether to hide
  void sensitivityChosen(double sensitivity); // by hand, in [1 / 64, 64]
  void closeRequested();

private:
  void choose(double distance);
  void showDistance();

  double usual_ = 1; // [L]
  double sensitivity_ = 1;
  OptionSlider* slider_;
  QDoubleSpinBox* number_;
  QToolButton* hide_;
  QLabel* left_;
};

} // namespace espalier
