#pragma once

#include "ui/tools/tool.h"

#include <optional>

namespace espalier {

/// Replaces what a node carries by what the scan shows there, once that is seen and accepted.
///
/// A click on a node, or being started from one, wants it regrown: who listens to wanted() does it,
/// and shows what grew. It ends when that is accepted or dropped.
class RegrowTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool hasPreview() const override { return node_.has_value(); }
  void accept() override;
  void cancel() override;
  void startWith(const std::vector<NodeId>& nodes) override;

  /// @param part  a tree; its root stands for `node`
  void show(NodeId node, const Skeleton& part);

signals:
  void wanted(espalier::NodeId node);

private:
  bool act(const ToolInput& input) override;

  std::optional<NodeId> node_; // to carry the part, while that is shown
  Skeleton part_;
};

} // namespace espalier
