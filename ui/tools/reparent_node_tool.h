#pragma once

#include "ui/tools/tool.h"

namespace espalier {

/// Hangs nodes, with all they carry, on the node clicked: started from nodes by a key, or with a
/// first click that chooses the node. It ends when that is done; a refusal lets one try again.
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
  void hangOn(NodeId parent);

  std::vector<NodeId> moving_;
};

} // namespace espalier
