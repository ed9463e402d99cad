#pragma once

#include "core/pipeline/grow_branches.h"
#include "ui/tools/tool.h"

#include <QPointF>

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// Replaces what a node carries by what the scan shows there, or adds the branches that are
/// missing, once that is seen and accepted.
///
/// A click on a node, or being started from one, wants it regrown: who listens to wanted() does it,
/// and shows what grew. Missing branches are wanted elsewhere, and shown only. It ends when that is
/// accepted or dropped.
///
/// Where several branches are proposed, they are walked: each is looked at, and taken or dropped,
/// and once all are, those taken are made, as one edit. To accept takes all that were not dropped.
///
/// Of missing branches the short ones are not shown at first, nor added: most are twigs of noise,
/// each of which would have to be looked at. How long one must be is raised and lowered meanwhile.
class RegrowTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool hasPreview() const override { return node_ || !branches_.empty(); }
  void accept() override;
  void cancel() override;
  void startWith(const std::vector<NodeId>& nodes) override;

  /// @param node  of the document
  /// @param part  a tree; its root stands for `node`
  void show(NodeId node, const Skeleton& part);
  /// @param text  of the step that adds them
  /// @param least length of the shortest branch to begin with [L], measured to its farthest tip
  void show(std::vector<GrownBranch> branches, const QString& text, double least = 0);

  /// Are there branches that are shown, or are not, which could be left out, or shown, as well?
  [[nodiscard]] bool canShowFewer() const { return shown_ > 1; }
  [[nodiscard]] bool canShowMore() const { return shown_ < branches_.size(); }
  void showFewer(); // by a fifth: the longest
  void showMore();

  /// Is there one of several branches to be taken or dropped?
  [[nodiscard]] bool canChoose() const { return current().has_value(); }
  void takeCurrent();
  void dropCurrent(); // and what it would carry

signals:
  void wanted(espalier::NodeId node);
  /// One of several branches is the next to be taken or dropped: its places [L].
  void reached(const std::vector<Eigen::Vector3d>& places);

private:
  /// A branch that is proposed: one of branches_, or an axis of part_.
  struct Proposal {
    std::vector<Eigen::Vector3d> places; // of its nodes [L]
    Preview look;
    double length = 0;              // [L]
    std::optional<std::size_t> on;  // the one that would carry it
    std::vector<NodeId> nodes = {}; // of part_
    bool isTaken = false;
    bool isDropped = false;
  };

  bool act(const ToolInput& input) override;
  void acceptPart();
  void acceptBranches();
  void begin(); // the walk
  void goOn();
  void preview(); // of the branches that are shown
  void clear();
  [[nodiscard]] std::size_t shown() const { return node_ ? proposals_.size() : shown_; }
  [[nodiscard]] std::optional<std::size_t> current() const;
  [[nodiscard]] std::size_t newNodes() const; // of all that were not dropped
  [[nodiscard]] QString walkHint() const;
  [[nodiscard]] QString branchesHint() const;

  std::optional<NodeId> node_; // to carry the part, while that is shown
  std::size_t carried_ = 0;    // by it when the part was shown
  Skeleton part_;
  std::vector<GrownBranch> branches_; // to choose from, the longest first
  std::vector<Proposal> proposals_;   // as many as branches_, or as part_ has axes
  std::size_t shown_ = 0;             // the first of these; what is accepted
  QString text_;
  std::optional<QPointF> pressedOnEdge_; // there
};

} // namespace espalier
