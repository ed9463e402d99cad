#pragma once

#include "ui/tools/tool.h"

#include <optional>

namespace espalier {

/// Adds nodes: pulled out of a node, inserted where an edge is pressed, or clicked onto the points
/// one after another, each a child of the one before.
///
/// A click on a node chooses where to go on from. In a plant without nodes the first click on a
/// point makes the root.
class AddNodeTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return pull_.has_value(); }
  void cancel() override;

private:
  struct Pull {
    std::optional<NodeId> parent; // to be given a child as soon as the pointer moves
    std::optional<NodeId> node;   // the new one
    Eigen::Hyperplane<double, 3> plane;
    Gesture gesture;
    QPointF screen;
    bool isCanceled = false; // the button is still down
  };

  bool act(const ToolInput& input) override;
  bool press(const ToolInput& input);
  void drag(const ToolInput& input);
  void clickPoint(const ToolInput& input);

  std::optional<Pull> pull_;
  std::optional<QPointF> camera_; // where the camera's gesture was pressed, until it moved
};

} // namespace espalier
