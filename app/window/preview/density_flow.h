#pragma once

#include "app/window/frame/window_part.h"
#include "ui/jobs/job_slot.h"

namespace espalier {

class PipelinePanel;
class PlantDocument;

/// Shows in the panel of the pipeline how dense the points of the scan lie, where radii follow it.
class DensityFlow : public WindowPart {
  Q_OBJECT

public:
  /// Both must outlive it.
  DensityFlow(PlantDocument& document, JobQueue& queue, PipelinePanel& pipeline);

  void refresh();
  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }

private:
  PlantDocument& document_;
  PipelinePanel& pipeline_;
  JobSlot job_;
};

} // namespace espalier
