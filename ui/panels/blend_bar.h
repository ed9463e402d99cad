#pragma once

#include <QFrame>

class QToolButton;

namespace espalier {

class OptionSlider;

/// A bar over the view that moves points between where they were scanned and where contraction put
/// them, and shows a line for each from the one to the other.
class BlendBar : public QFrame {
  Q_OBJECT

public:
  explicit BlendBar(QWidget* parent = nullptr);

  [[nodiscard]] double blend() const; // 0: as scanned; 1: contracted
  void setBlend(double blend);
  [[nodiscard]] bool showsDisplacements() const;

signals:
  void changed();
  void closeRequested();

private:
  OptionSlider* slider_;
  QToolButton* displacements_;
};

} // namespace espalier
