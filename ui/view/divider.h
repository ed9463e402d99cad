#pragma once

#include <QWidget>

namespace espalier {

/// The line in a view between two states of the plant. Dragged, or moved by the arrow keys once
/// Tab has reached it, it asks to be elsewhere.
class Divider : public QWidget {
  Q_OBJECT

public:
  explicit Divider(QWidget* view);

  void place(double across, bool dark); // of the width of the view, in [0, 1]

signals:
  void moveAsked(double across);
  void entered(); // the pointer is no longer over the plant

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  void ask(double across);

  double across_ = 0.5;
  bool dark_ = false;
};

} // namespace espalier
