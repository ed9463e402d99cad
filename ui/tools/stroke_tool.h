#pragma once

#include "ui/tools/tool.h"
#include "ui/tools/trace_question.h"

#include <QLineF>
#include <QPolygonF>

#include <cstdint>
#include <optional>

namespace espalier {

/// Draws edits with one stroke: across edges it cuts them, along points it makes a branch, and
/// around or over a crossing of two branches it exchanges their arms.
///
/// What it would do is shown while it is drawn. Shift only cuts, Alt only exchanges, both together
/// only make a branch. A branch waits for who listens to asked() to find the middle of the wood.
class StrokeTool : public Tool {
  Q_OBJECT

public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool isBusy() const override { return isDrawing_ || isWaiting_; }
  void cancel() override;

signals:
  void asked(const espalier::TraceQuestion& question, const espalier::TraceAnswer& answer);

private:
  enum class Kind : std::uint8_t { nothing, cut, exchange, branch };
  /// An edge as it is seen.
  struct SeenEdge {
    NodeId child;
    QLineF line; // from the parent
  };

  bool act(const ToolInput& input) override;
  void press(const ToolInput& input);
  void drag(const ToolInput& input);
  void release();
  void reset();
  [[nodiscard]] bool goesOn(const Eigen::Vector3d& point, const ToolInput& input) const;
  void findCrossed(const QLineF& stretch);
  [[nodiscard]] bool isHidden(const SeenEdge& edge) const;
  [[nodiscard]] Kind kind() const;
  [[nodiscard]] bool isLoop() const;
  [[nodiscard]] bool hasStart() const { return startNode_ || startEdge_; }
  [[nodiscard]] std::vector<NodeId> arms() const;
  void cut();
  void exchange();
  void askForBranch();
  void makeBranch(const Trace& trace);

  bool isDrawing_ = false;
  bool isCanceled_ = false; // the button is still down
  bool isWaiting_ = false;  // for the answer
  int question_ = 0;        // number of the last one asked
  Qt::KeyboardModifiers modifiers_;
  QPolygonF stroke_;
  std::vector<Eigen::Vector3d> places_; // on the points along it
  std::optional<NodeId> startNode_;
  std::optional<EdgePick> startEdge_;
  std::vector<SeenEdge> seen_;
  std::vector<SeenEdge> crossed_;       // in order
  std::vector<SeenEdge> crossedBehind_; // wood: these are not cut
};

} // namespace espalier
