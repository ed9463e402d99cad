#pragma once

#include "ui/tools/tool.h"

#include <optional>

namespace espalier {

/// Attaches nodes, with all they bear, elsewhere: a node is dragged onto its new parent, or clicked
/// and then its parent. A place on an edge is a parent too: it gets a node of its own.
///
/// Enter attaches them to what is shown: what the pointer is on or, where keys were used last, the
/// node that they have stepped to; before any step the one they most likely grow from.
///
/// Started from nodes by a key it ends when that is done; chosen as a tool it goes on with the next
/// node. A refusal lets one try again.
class ReparentNodeTool : public Tool {
  Q_OBJECT

public:
  ReparentNodeTool(PlantDocument& document, Canvas& canvas, QObject* parent = nullptr);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return !moving_.empty(); }
  [[nodiscard]] bool hasPreview() const override { return aim().has_value(); }
  void accept() override;
  void cancel() override;
  void startWith(const std::vector<NodeId>& nodes) override;

private:
  bool act(const ToolInput& input) override;
  bool press(const ToolInput& input);
  bool release(const ToolInput& input);
  void take(const std::vector<NodeId>& nodes);
  [[nodiscard]] bool isCarried(const Pick& target) const; // pre: isTarget(target)
  void attachTo(const Pick& target);
  void followSelection();
  void dropGone();                               // nodes that an edit has removed
  [[nodiscard]] std::optional<Pick> aim() const; // what they would be attached to now
  [[nodiscard]] bool isTarget(const Pick& pick) const;
  [[nodiscard]] bool isMoving(const Pick& pick) const;
  void refuseClick(const Pick& pick) const;
  [[nodiscard]] std::vector<Eigen::Vector3d> subjects() const;
  void preview(const ToolInput& input);
  void show(const std::optional<Eigen::Vector3d>& end);
  [[nodiscard]] std::optional<Eigen::Vector3d> placeOf(const std::optional<Pick>& pick) const;
  void end();

  std::vector<NodeId> moving_;
  std::optional<NodeId> likely_; // parent: the first that is proposed
  QPointF pointer_;
  bool isByKeys_ = false; // since the pointer moved
  bool endsWhenDone_ = false;
  std::optional<QPointF> pressed_; // where, while the button is down on a node to be moved
  bool isDragging_ = false;
  std::optional<QPointF> missed_; // where the button went down for a new parent, and is on none
};

} // namespace espalier
