#pragma once

#include "ui/tools/area_gesture.h"
#include "ui/tools/tool.h"

#include <cstdint>
#include <optional>

namespace espalier {

/// Chooses points of the scan with a round brush, boxes and lassos.
///
/// What is drawn replaces what was chosen; with Shift it adds to that, with Alt it takes away from
/// it. A click beside all points chooses none. Like the pointer, it takes what is seen, or all.
class SelectPointsTool : public Tool {
  Q_OBJECT

public:
  enum class Shape : std::uint8_t { brush, box, lasso };

  SelectPointsTool(PlantDocument& document, Canvas& canvas, QObject* parent = nullptr)
      : Tool(document, canvas, parent), area_(canvas) {}

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return how_.has_value(); }
  void cancel() override;

  [[nodiscard]] Shape shape() const { return shape_; }
  void setShape(Shape shape);
  [[nodiscard]] double brushSize() const { return brush_; } // radius, in logical pixels
  /// Kept between 3 and 300.
  void setBrushSize(double radius);

private:
  enum class How : std::uint8_t { replace, add, takeAway };

  bool act(const ToolInput& input) override;
  void press(const ToolInput& input);
  void paint(const ToolInput& input);
  void endArea(const ToolInput& input);
  void choose(const PointSet& points);
  void showBrush();
  void reset();

  Shape shape_ = Shape::brush;
  double brush_ = 16; // logical pixels
  AreaGesture area_;
  std::optional<How> how_; // while the button is down
  bool isCanceled_ = false;
  PointSet before_; // chosen when it was pressed
  PointSet painted_;
  std::optional<QPointF> pointer_; // where it was last
};

} // namespace espalier
