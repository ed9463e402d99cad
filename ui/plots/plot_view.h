#pragma once

#include "ui/plots/tolerance_plot.h"

#include <QWidget>

namespace espalier {

/// The curve of a comparison on the screen; a drag in it chooses the tolerance, as do the arrow
/// keys.
class PlotView : public QWidget {
  Q_OBJECT

public:
  explicit PlotView(QWidget* parent = nullptr);

  void show(const TolerancePlot& plot);
  void setStale(bool isStale); // painted pale
  void setDark(bool isDark);
  [[nodiscard]] QSize sizeHint() const override { return {320, 170}; }

signals:
  void toleranceChosen(double tolerance);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void choose(const QPointF& place);

  TolerancePlot plot_;
  bool isStale_ = false;
  bool isDark_ = false;
};

} // namespace espalier
