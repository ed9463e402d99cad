#pragma once

#include <QSlider>

namespace espalier {

/// A slider from 0 to 1 whose track shows where the default is. A double click goes there.
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
  void wheelEvent(QWheelEvent* event) override; // left to the page: it is scrolled far more often

private:
  double defaultPlace_ = 0;
};

} // namespace espalier
