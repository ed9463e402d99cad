#pragma once

#include "app/window/frame/window_part.h"
#include "core/pipeline/grow_branches.h"
#include "core/pipeline/pipeline.h"
#include "ui/jobs/job_slot.h"
#include "ui/tools/trace_question.h"

#include <functional>
#include <memory>
#include <optional>

namespace espalier {

class ActionSet;
class Editing;
class PlantDocument;
class PlantView;
class RegrowTool;
class TraceTool;

/// Answers the tools that work along the points: traces, strokes, and what is regrown.
///
/// What all traces through a scan share is made when a tool asks first, and kept until another scan
/// is shown. Questions never queue: of those asked while one is answered, the last is answered
/// next.
class TraceFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    Editing& editing;
    JobSlot& jobs; // for what replaces nodes; traces have their own
    std::function<PipelineOptions()> options;
  };
  explicit TraceFlow(const Parts& parts);

  [[nodiscard]] bool isBusy() const override { return traces_.isBusy() || next_.has_value(); }

private:
  struct Asked {
    TraceQuestion question;
    TraceAnswer answer;
  };
  void ask(const TraceQuestion& question, const TraceAnswer& answer);
  void work();
  void makeGraph();
  [[nodiscard]] std::shared_ptr<const EdgeIndex> wood(); // of the plant, as it is now
  void forget();
  void addGrowing();
  [[nodiscard]] PipelineOptions options() const;
  void requireWork() const; // that the points and the plant may be worked on
  void regrow(NodeId node);
  void regrowMissing();
  void growFromPoints();
  void lookAt(const std::vector<Eigen::Vector3d>& places);
  /// @param least length of the shortest branch that is shown at first [L]
  void show(std::vector<GrownBranch> branches, const QString& text, double least);

  Parts parts_;
  TraceTool* tool_;
  RegrowTool* regrow_;
  std::shared_ptr<const TraceGraph> graph_; // of the scan shown; null until it is asked for
  std::shared_ptr<const EdgeIndex> wood_;   // null: the plant has changed since
  std::optional<Asked> next_;
  JobSlot traces_{parts_.jobs.queue(), JobPriority::hand};
};

} // namespace espalier
