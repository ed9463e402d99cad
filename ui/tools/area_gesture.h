#pragma once

#include "ui/document/canvas.h"
#include "ui/document/tool_input.h"

#include <cstdint>
#include <optional>

namespace espalier {

/// A drag that draws a box or a lasso over the view, for the tools that choose by area.
class AreaGesture {
public:
  enum class Shape : std::uint8_t { box, lasso };

  explicit AreaGesture(Canvas& canvas) : canvas_(canvas) {}

  /// What a press of the left button begins: with Shift a box, with Alt a lasso, else nothing.
  [[nodiscard]] static std::optional<Shape> shapeOf(const ToolInput& press);

  void begin(Shape shape, const ToolInput& press);
  void drag(const ToolInput& input); // shows the band, once the hand has moved
  /// The area drawn, and takes the band away. None for a click, or if it was canceled.
  [[nodiscard]] std::optional<QPolygonF> end();
  void cancel(); // takes the band away; the button may still be down

  [[nodiscard]] bool isActive() const { return shape_.has_value(); }
  [[nodiscard]] bool hasMoved() const { return hasMoved_; }
  [[nodiscard]] bool isCanceled() const { return isCanceled_; }

private:
  Canvas& canvas_;
  std::optional<Shape> shape_; // while the button is down
  QPolygonF area_;             // closed
  QPolygonF pointerPath_;      // of the pointer
  bool hasMoved_ = false;
  bool isCanceled_ = false;
};

} // namespace espalier
