#pragma once

#include "app/window/frame/window_part.h"
#include "core/pipeline/method_sight.h"
#include "ui/jobs/job_slot.h"

#include <QTimer>

#include <memory>
#include <optional>

class QAction;

namespace espalier {

class ActionSet;
class Editing;
class PipelinePanel;
class PlantDocument;
class PlantView;
class PreviewFlow;

/// Draws what the chosen methods see at the point under the mouse: its neighbors, the points its
/// new place is from, directions, circles, and the cones of point tracking.
class SightFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PlantView& view;
    PipelinePanel& pipeline;
    ActionSet& actions;
    Editing& editing;
    PreviewFlow& preview;
  };
  explicit SightFlow(const Parts& parts);

private:
  void turn(bool isOn);
  void prepare();
  void look();
  [[nodiscard]] Eigen::Index pointAt(const Eigen::Vector3f& place) const; // about the origin

  Parts parts_;
  QAction* show_;
  std::shared_ptr<const MethodSights> sights_; // null: not ready
  QTimer timer_;                               // many moves of the mouse are one
  std::optional<Eigen::Index> shown_;
  JobSlot job_{parts_.queue, JobPriority::hand};
};

} // namespace espalier
