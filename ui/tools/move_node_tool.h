#pragma once

#include "ui/tools/tool.h"

#include <optional>
#include <utility>

namespace espalier {

/// Chooses nodes with clicks, and drags them in the plane of the screen. The default tool.
///
/// A drag of a chosen node moves all that are chosen. A click on an edge chooses the node it leads
/// to; a click on nothing chooses none; a drag on nothing is left to the camera.
class MoveNodeTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return drag_.has_value(); }
  void cancel() override;

private:
  struct Drag {
    NodeId node; // the one pressed on
    std::vector<std::pair<NodeId, Eigen::Vector3d>> start;
    Eigen::Hyperplane<double, 3> plane;
    Eigen::Vector3d grip; // where the pointer met the plane
    Gesture gesture;
    QPointF screen;
    bool hasMoved = false;
    bool isCanceled = false; // the button is still down
  };

  bool act(const ToolInput& input) override;
  bool press(const ToolInput& input);
  void drag(const ToolInput& input);
  void click(const ToolInput& input);

  std::optional<Drag> drag_;
  std::optional<QPointF> camera_; // where the camera's gesture was pressed, until it moved
};

} // namespace espalier
