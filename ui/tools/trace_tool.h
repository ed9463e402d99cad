#pragma once

#include "ui/tools/tool.h"
#include "ui/tools/trace_question.h"

#include <optional>

namespace espalier {

/// Finds a branch along the points between two places that are clicked, and makes it once accepted.
///
/// The path to the place under the pointer is shown as it moves; a click holds it there and finds
/// other paths. It is attached to the node or edge it starts at; started on points, it is a tree of
/// its own, or attached to the node it ends at. A tree whose node it ends at is joined to it.
///
/// The paths are found elsewhere, by who listens to asked(): the mouse never waits for them.
class TraceTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return start_.has_value(); }
  [[nodiscard]] bool hasPreview() const override { return start_ && !traces_.empty(); }
  void accept() override;
  void cancel() override;

  [[nodiscard]] bool hasOtherPaths() const { return traces_.size() > 1; }
  void showNextPath();
  /// How far the points have been made ready for questions, in [0, 1].
  void showReadiness(double fraction);

signals:
  void asked(const espalier::TraceQuestion& question, const espalier::TraceAnswer& answer);

private:
  /// A place that was clicked.
  struct End {
    std::optional<NodeId> node;
    std::optional<EdgePick> edge;
    Eigen::Vector3d place;
    bool operator==(const End& other) const { return node == other.node && place == other.place; }
  };

  bool act(const ToolInput& input) override;
  void click(const Pick& pick);
  [[nodiscard]] std::optional<End> endAt(const Pick& pick) const;
  void ask(const End& end, int alternatives);
  void show();
  void requireNoLoop(const End& end) const;
  [[nodiscard]] bool isSameTree(const End& end) const;
  void apply(SkeletonEditor& editor, const Trace& trace);

  std::optional<End> start_;
  std::optional<End> end_; // the one asked about last
  bool isHeld_ = false;    // the end was clicked: the pointer is free
  int question_ = 0;       // number of the last one asked
  std::vector<Trace> traces_;
  End shownEnd_ = {};
  std::size_t shown_ = 0; // which of them
  double readiness_ = 1;
  std::optional<QPointF> pressed_;
};

} // namespace espalier
