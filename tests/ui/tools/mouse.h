#pragma once

#include "ui/tools/tool.h"

#include <Eigen/Core>

namespace espalier::test {

/// A mouse for tools without a window: an eye at (0, -10, 0) looks along y, and one pixel is 0.01
/// in the plane y = 0. Rays are parallel, so a drag moves what is at any depth by the same length.
class Mouse {
public:
  explicit Mouse(Tool& tool) : tool_(tool) {}

  bool press(const Pick& pick, const Eigen::Vector2d& at,
             Qt::KeyboardModifiers modifiers = Qt::NoModifier,
             Qt::MouseButton button = Qt::LeftButton);
  bool hover(const Pick& pick, const Eigen::Vector2d& at);
  bool drag(const Eigen::Vector2d& at, const Pick& pick = {});
  bool release(const Pick& pick = {});
  void hold(Qt::KeyboardModifiers modifiers) { modifiers_ = modifiers; } // from now on
  bool escape();
  bool click(const Pick& pick, const Eigen::Vector2d& at,
             Qt::KeyboardModifiers modifiers = Qt::NoModifier);

private:
  [[nodiscard]] ToolInput input(ToolInput::Phase phase, const Pick& pick) const;

  Tool& tool_;
  Eigen::Vector2d at_ = Eigen::Vector2d::Zero(); // x and z
  Qt::MouseButton button_ = Qt::NoButton;
  Qt::KeyboardModifiers modifiers_;
};

[[nodiscard]] Pick onNode(NodeId id);
[[nodiscard]] Pick onEdge(const Skeleton& plant, NodeId child, double fraction);
[[nodiscard]] Pick onPoint(const Eigen::Vector3d& place);

} // namespace espalier::test
