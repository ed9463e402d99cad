#pragma once

#include <QFrame>
#include <QString>

#include <optional>

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace espalier {

class OptionSlider;

/// A bar over the view: from what distance to the skeleton on points stay bright, and whether the
/// others are dimmed or hidden.
class ExplainedBar : public QFrame {
  Q_OBJECT

public:
  explicit ExplainedBar(QWidget* parent = nullptr);

  /// The default is 4 spacings between points [L]; what was chosen by hand stays.
  void setSpacing(double spacing, const QString& unit);
  void forgetDistance(); // back to the default: another plant

  [[nodiscard]] double distance() const; // [L]
  [[nodiscard]] bool isHiding() const;   // else dimming
  void setHiding(bool isHiding);
  void showLeft(const QString& text); // how much is left

signals:
  void changed();
  void closeRequested();

private:
  void choose(std::optional<double> distance);
  void showDistance();

  double spacing_ = 1;           // [L], > 0
  std::optional<double> chosen_; // [L]; none: the default
  OptionSlider* slider_;
  QDoubleSpinBox* number_;
  QToolButton* hide_;
  QLabel* left_;
};

} // namespace espalier
