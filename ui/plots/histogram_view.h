#pragma once

#include "ui/plots/histogram_plot.h"

#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

namespace espalier {

/// Numbers for a histogram. Those that are not finite are left out.
struct PlottedValues {
  std::vector<float> values;
  QString title;
  QString unit;
  /// What is shown; none: from the values, see binned().
  std::optional<std::pair<double, double>> range;
  std::optional<HistogramPlot::Mark> mark = {};
  bool areComing = false; // they are computed yet: their title is there first
};

/// A histogram in which a drag marks a range of values, as do the arrow keys: Left and Right move
/// it, Up and Down widen and narrow it. Shift: finely. Escape or a click takes it away.
class HistogramView : public QWidget {
  Q_OBJECT

public:
  explicit HistogramView(QWidget* parent = nullptr);

  /// Shows other values. The brush stays if they have the same title, else it is taken away,
  /// without a signal.
  void show(const PlottedValues& values);
  /// Draws values of another set as an outline over the bars, in the same bins; none: no outline.
  void addSecond(const std::vector<float>& values, const QString& name = {});
  void setDark(bool isDark);
  [[nodiscard]] const HistogramPlot& plot() const { return plot_; }
  [[nodiscard]] QSize sizeHint() const override { return {320, 130}; }

signals:
  void brushed(double from, double to, bool isFinal); // not final: in mid-drag
  void brushCleared();

protected:
  bool event(QEvent* event) override; // tips; its keys are no shortcuts
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;

private:
  struct Drag {
    double start;  // where the mouse was pressed [px]
    double at;     // where it marks: behind the mouse where this was moved finely [px]
    double mouse;  // at its last move [px]
    double anchor; // the value at the other end
    std::optional<HistogramPlot::Brush> before;
    bool hasMoved = false;
  };

  [[nodiscard]] bool isMeant(const QKeyEvent& event) const;
  [[nodiscard]] std::optional<double> farEnd(double x) const; // of the brush, if x grips an end
  void mark(double from, double to);
  void clear();
  void cancelDrag();
  void step(double move, double widen);
  void reportMarked(bool isFinal);
  void describe();

  std::vector<float> values_;
  std::vector<float> secondValues_;
  HistogramPlot plot_;
  std::optional<Drag> drag_;
  bool isKeyHeld_ = false; // a brush moved by a held key is not final
  bool isDark_ = false;
};

} // namespace espalier
