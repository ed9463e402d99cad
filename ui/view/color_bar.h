#pragma once

#include "ui/view/legend.h"

#include <QWidget>

#include <functional>
#include <optional>

class QLineEdit;

namespace espalier {

/// The handles at the ends of a color bar: dragged, they set the range of its colors; a double
/// click gives the usual range back; a click on the number at an end lets one type it.
///
/// Lies over what paintLegends() painted, and leaves to the view what is not for a handle.
class ColorBar : public QWidget {
  Q_OBJECT

public:
  enum class End { from, to };

  explicit ColorBar(QWidget* view);

  /// @param box    of the legend, in the coordinates of the view
  /// @param chosen the range set by hand; none: the legend has its usual one
  void showLegend(const Legend& legend, const LegendBox& box, std::optional<ValueRange> chosen,
                  bool dark);

  [[nodiscard]] bool isDragging() const { return dragged_.has_value(); }
  void cancel(); // ends the drag with the range from before
  void type(End end);

signals:
  /// None: the usual range. While a handle is dragged, `isFinal` is false.
  void rangeChosen(const QString& id, std::optional<espalier::ValueRange> range, bool isFinal);
  void entered(); // the pointer is at a handle, and no longer over the plant

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  [[nodiscard]] std::optional<End> endAt(const QPointF& place) const;
  [[nodiscard]] double placeOf(End end) const; // down from the top of the widget
  [[nodiscard]] ValueRange range() const { return {legend_.from, legend_.to}; }
  void hover(std::optional<End> end);
  void drag(const QPointF& place);
  void takeTyped(End end, const QString& text);

  Legend legend_;
  LegendBox box_; // in the coordinates of the widget
  std::optional<ValueRange> chosen_;
  bool dark_ = false;
  std::optional<End> hovered_;
  std::optional<End> dragged_;
  bool hasMoved_ = false;
  QPointF pressed_;
  std::optional<ValueRange> before_; // the drag
  Legend legendBefore_;              // the drag: it is measured along this axis
};

} // namespace espalier
