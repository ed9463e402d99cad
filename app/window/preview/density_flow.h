#pragma once

#include "app/window/frame/window_part.h"
#include "ui/jobs/latest_job.h"

namespace espalier {

class PipelinePanel;
class PlantDocument;

/// Tells the panel of the pipeline how dense the points of the scan lie, where radii follow it.
class DensityFlow : public WindowPart {
  Q_OBJECT

public:
  /// Both must outlive it.
  DensityFlow(PlantDocument& document, PipelinePanel& pipeline);

  void refresh();
  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }

private:
  PlantDocument& document_;
  PipelinePanel& pipeline_;
  LatestJob job_;
};

} // namespace espalier
