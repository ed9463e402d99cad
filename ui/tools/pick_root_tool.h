#pragma once

#include "ui/tools/tool.h"

#include <optional>

namespace espalier {

/// Chooses where the plant is rooted when it is reconstructed: a click on a point of the scan, at
/// the foot of the trunk. It ends with that. The plant itself stays as it is.
class PickRootTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  void cancel() override;
  void leave() override;

private:
  bool act(const ToolInput& input) override;
  void click(const Pick& pick);
  /// The point of the scan that is meant; none: nothing is under the pointer.
  [[nodiscard]] std::optional<Eigen::Vector3d> placeOf(const Pick& pick) const;

  std::optional<QPointF> press_; // until it is a drag
  bool isShown_ = false;         // where the root would be
};

} // namespace espalier
