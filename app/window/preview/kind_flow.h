#pragma once

#include "app/window/frame/window_part.h"
#include "core/pipeline/kind_of_scan.h"
#include "ui/jobs/job_slot.h"

#include <optional>

namespace espalier {

class ActionSet;
class KindLine;
class PipelinePanel;
class PlantDocument;

/// Says in the panel of the pipeline what the plant of the scan probably is, before it is
/// reconstructed, and offers the settings for such plants, then and later; it takes none by itself.
class KindFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PipelinePanel& pipeline;
    ActionSet& actions;
  };
  explicit KindFlow(const Parts& parts);

  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }
  void stop() override { job_.cancel(); }

private:
  void guess();
  void take();
  void refresh();
  [[nodiscard]] bool isTaken() const; // pre: kind_

  Parts parts_;
  KindLine* line_;
  std::optional<KindOfScan> kind_;
  JobSlot job_;
};

} // namespace espalier
