#pragma once

#include "ui/tools/tool.h"

#include <optional>

namespace espalier {

/// Attaches nodes, with all they bear, elsewhere: a node is dragged onto its new parent, or clicked
/// and then its parent. A place on an edge is a parent too: it gets a node of its own.
///
/// Started from nodes by a key it ends when that is done; chosen as a tool it goes on with the next
/// node. A refusal lets one try again.
class ReparentNodeTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return !moving_.empty(); }
  void cancel() override;
  void startWith(const std::vector<NodeId>& nodes) override;

private:
  bool act(const ToolInput& input) override;
  bool press(const ToolInput& input);
  bool release(const ToolInput& input);
  void take(const std::vector<NodeId>& nodes);
  void attachTo(const Pick& target);
  [[nodiscard]] bool isMoving(const Pick& pick) const;
  [[nodiscard]] std::vector<Eigen::Vector3d> subjects() const;
  void preview(const ToolInput& input);
  void end();

  std::vector<NodeId> moving_;
  bool endsWhenDone_ = false;
  std::optional<QPointF> pressed_; // where, while the button is down on a node to be moved
  bool isDragging_ = false;
};

} // namespace espalier
