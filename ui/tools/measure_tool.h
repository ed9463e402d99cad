#pragma once

#include "core/skeleton/length_along.h"
#include "ui/tools/tool.h"

#include <optional>
#include <vector>

namespace espalier {

/// Measures between two things that are clicked, nodes, edges or points: straight, and along the
/// plant where both are on it. A third click gives the angle at the second. Enter gives it
/// the node that is selected. It edits nothing.
///
/// What was measured on the plant moves with it; it goes when a node of it does.
class MeasureTool : public Tool {
  Q_OBJECT

public:
  MeasureTool(PlantDocument& document, Canvas& canvas, QObject* parent = nullptr);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return marks_.size() == 1; }
  [[nodiscard]] bool takesNodes() const override { return true; }
  void takeNode(NodeId id) override;
  [[nodiscard]] QString result() const override;
  void cancel() override;

private:
  struct Mark {
    std::optional<SkeletonPlace> place; // none: a point
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
  };

  bool act(const ToolInput& input) override;
  void add(const Mark& mark);
  void follow();
  void show();
  [[nodiscard]] static std::optional<Mark> markOf(const Pick& pick);
  [[nodiscard]] Eigen::Vector3d positionOf(const Mark& mark) const;
  [[nodiscard]] QString describe(const std::vector<Mark>& marks, const QString& between) const;

  std::vector<Mark> marks_;  // 3 at most
  std::optional<Mark> next_; // under the pointer
  bool isShown_ = false;
  std::optional<QPointF> press_; // until it is a drag
};

} // namespace espalier
