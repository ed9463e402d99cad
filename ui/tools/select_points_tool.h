#pragma once

#include "ui/tools/area_gesture.h"
#include "ui/tools/thing_gesture.h"
#include "ui/tools/tool.h"

#include <cstdint>
#include <optional>

namespace espalier {

/// Chooses points of the scan with a round brush, boxes and lassos, or all of a thing by clicks.
///
/// What is drawn replaces what was chosen; with Shift it adds to that, with Alt it takes away from
/// it. A click beside all points chooses none. Like the pointer, it takes what is seen, or all.
/// What a thing consists of is asked: it may take long to find.
class SelectPointsTool : public Tool {
  Q_OBJECT

public:
  enum class Shape : std::uint8_t { brush, box, lasso, thing };

  SelectPointsTool(PlantDocument& document, Canvas& canvas, QObject* parent = nullptr)
      : Tool(document, canvas, parent), area_(canvas), clicks_(canvas) {}

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return how_.has_value() || clicks_.isBegun(); }
  void cancel() override;
  void leave() override;

  [[nodiscard]] Shape shape() const { return shape_; }
  void setShape(Shape shape);
  void setThing(PointQuestion::Thing thing); // to be clicked
  [[nodiscard]] std::optional<PointQuestion::Thing> thing() const {
    return shape_ == Shape::thing ? std::optional(clicks_.thing()) : std::nullopt;
  }
  [[nodiscard]] double brushSize() const { return brush_; } // radius, in logical pixels
  /// Kept between 3 and 300.
  void setBrushSize(double radius);

  /// What the points become that are selected, for the hint; empty: they are only selected.
  void setPurpose(const QString& purpose);

signals:
  void ended(); // a gesture that selects, not canceled
  void asked(const espalier::PointQuestion& question, const espalier::PointAnswer& answer);

private:
  enum class How : std::uint8_t { replace, add, takeAway };

  bool act(const ToolInput& input) override;
  void press(const ToolInput& input);
  void paint(const ToolInput& input);
  void endArea(const ToolInput& input);
  bool click(const ToolInput& input);
  [[nodiscard]] static How howBy(Qt::KeyboardModifiers modifiers);
  [[nodiscard]] QString hintOfShape() const;
  void choose(const PointSet& points);
  [[nodiscard]] static PointSet joined(const PointSet& before, const PointSet& points, How how);
  void showBrush();
  void reset();

  Shape shape_ = Shape::brush;
  QString purpose_;
  double brush_ = 16; // logical pixels
  AreaGesture area_;
  ThingGesture clicks_;
  std::optional<How> how_; // while the button is down
  bool isCanceled_ = false;
  PointSet before_; // chosen when it was pressed
  PointSet painted_;
  std::optional<QPointF> pointer_; // where it was last
};

} // namespace espalier
