#pragma once

#include "core/pipeline/grow_branches.h"
#include "ui/tools/tool.h"

#include <optional>
#include <vector>

namespace espalier {

/// Replaces what a node carries by what the scan shows there, or adds the branches that are
/// missing, once that is seen and accepted.
///
/// A click on a node, or being started from one, wants it regrown: who listens to wanted() does it,
/// and shows what grew. Missing branches are wanted elsewhere, and shown only. It ends when that is
/// accepted or dropped.
class RegrowTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool hasPreview() const override { return node_ || !branches_.empty(); }
  void accept() override;
  void cancel() override;
  void startWith(const std::vector<NodeId>& nodes) override;

  /// @param part  a tree; its root stands for `node`
  void show(NodeId node, const Skeleton& part);
  /// @param text  of the step that adds them
  void show(std::vector<GrownBranch> branches, const QString& text);

signals:
  void wanted(espalier::NodeId node);

private:
  bool act(const ToolInput& input) override;
  void acceptBranches();

  std::optional<NodeId> node_; // to carry the part, while that is shown
  Skeleton part_;
  std::vector<GrownBranch> branches_; // while they are shown
  QString text_;
};

} // namespace espalier
