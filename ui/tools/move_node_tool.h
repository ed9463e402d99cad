#pragma once

#include "ui/tools/area_gesture.h"
#include "ui/tools/tool.h"

#include <QTimer>

#include <cstdint>
#include <optional>
#include <utility>

namespace espalier {

/// What a node that is dragged is drawn to.
enum class Snap : std::uint8_t {
  nothing,
  contracted, // the middle of the nearest contracted points
  section     // the middle of the circle of points around it
};

/// Chooses nodes with clicks, boxes and lassos, and drags them in the plane of the screen. The
/// default tool.
///
/// A drag of a chosen node moves all that are chosen. A click on an edge chooses the node it leads
/// to; a click on nothing chooses none; a drag on nothing is left to the camera. A drag with Shift
/// draws a box, with Alt a lasso; Shift still held at its end adds to what is chosen. In a plant
/// that may not be edited it only chooses.
///
/// Nodes that are dragged snap, each by itself, to what snap() says, where that is near; of many,
/// those nearest to the pointer at once, the others as soon as it rests. With Ctrl they do not
/// snap, or if nothing is to be snapped to, to their sections. With Shift a node that is dragged
/// alone slides along its axis.
class MoveNodeTool : public Tool {
  Q_OBJECT

public:
  MoveNodeTool(PlantDocument& document, Canvas& canvas, QObject* parent = nullptr);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return drag_ || area_.isActive(); }
  void cancel() override;

  [[nodiscard]] Snap snap() const { return snap_; }
  void setSnap(Snap snap);

private:
  struct Drag {
    NodeId node;                                           // the one pressed on
    std::vector<std::pair<NodeId, Eigen::Vector3d>> start; // those near to `node` first
    std::size_t snapped = 0;                               // of these, since the last drag
    Eigen::Hyperplane<double, 3> plane;
    Eigen::Vector3d grip; // where the pointer met the plane
    Gesture gesture;
    QPointF screen;
    bool hasMoved = false;
    bool isCanceled = false; // the button is still down
    bool slides = false;     // now
    Snap snap = Snap::nothing;
  };

  bool act(const ToolInput& input) override;
  bool press(const ToolInput& input);
  void drag(const ToolInput& input);
  void release();
  void move(SkeletonEditor& editor, const Eigen::Vector3d& shift, const ToolInput& input);
  void snapMore(SkeletonEditor& editor); // of what was moved
  void snapResting();                    // the same, while the pointer rests
  void snapAll();                        // what is let go
  [[nodiscard]] QString editText() const;
  [[nodiscard]] std::optional<Eigen::Vector3d> snapped(const Skeleton& skeleton, NodeId id) const;
  void click(const ToolInput& input);
  void endArea(const ToolInput& input);
  void choose(const Pick& pick, bool adds);
  [[nodiscard]] QString areaHint() const;
  [[nodiscard]] QString dragHint() const;

  Snap snap_ = Snap::nothing;
  std::optional<Drag> drag_;
  QTimer rest_; // until the pointer rests
  AreaGesture area_;
  Pick pressedOn_;                // where the area began
  std::optional<QPointF> camera_; // where the camera's gesture was pressed, until it moved
};

} // namespace espalier
