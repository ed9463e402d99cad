#pragma once

#include "ui/tools/tool.h"

namespace espalier {

/// Leaves the mouse to the camera, over nodes too: nothing can be moved by mistake.
class NavigateTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;

private:
  bool act(const ToolInput& /*input*/) override { return false; }
};

} // namespace espalier
