#pragma once

#include "ui/document/canvas.h"
#include "ui/document/tool_input.h"
#include "ui/tools/point_question.h"

#include <QCoreApplication>
#include <QPointF>
#include <QString>

#include <optional>

namespace espalier {

/// Clicks on a thing in the scan, for the tool that selects all of its points. A drag is none: it
/// moves the camera.
class ThingGesture {
  Q_DECLARE_TR_FUNCTIONS(ThingGesture)

public:
  explicit ThingGesture(Canvas& canvas) : canvas_(canvas) {}

  void begin(PointQuestion::Thing thing);
  [[nodiscard]] PointQuestion::Thing thing() const { return question_.thing; }
  [[nodiscard]] QString hint() const; // what the next click does

  void hover(const ToolInput& input); // shows what would be clicked
  void press(const ToolInput& input);
  void drag(const ToolInput& input);
  /// What is asked after the last click. None: it was no click, or there are more to come.
  /// @throws Error if it met no point
  [[nodiscard]] std::optional<PointQuestion> release(const ToolInput& input);
  void cancel();

  [[nodiscard]] bool isPressed() const { return press_.has_value(); }
  [[nodiscard]] bool isBegun() const { return !question_.places.empty(); } // more clicks to come

private:
  [[nodiscard]] std::size_t clicks() const; // of this thing
  void show(const std::optional<Eigen::Vector3d>& next);

  Canvas& canvas_;
  PointQuestion question_; // as far as it was clicked
  std::optional<QPointF> press_;
  bool isShown_ = false;
};

} // namespace espalier
