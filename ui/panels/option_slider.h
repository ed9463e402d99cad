#pragma once

#include <QSlider>

#include <optional>

namespace espalier {

/// A slider from 0 to 1 whose track shows where the default is. A double click goes there; with
/// Shift the handle moves a tenth as far as the mouse.
class OptionSlider : public QSlider {
  Q_OBJECT

public:
  explicit OptionSlider(QWidget* parent = nullptr);

  void setPlace(double place); // in [0, 1]
  void setDefaultPlace(double place);
  [[nodiscard]] double place() const;

signals:
  void defaultRequested();

protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override; // left to the page: it is scrolled far more often

private:
  struct FineDrag {
    double x;     // of the mouse, at its last move [px]
    double value; // between the slider's steps
  };

  double defaultPlace_ = 0;
  std::optional<FineDrag> fine_; // once begun it lasts to the release: the handle does not jump
};

} // namespace espalier
