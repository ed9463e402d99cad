#pragma once

#include "app/window/frame/window_part.h"
#include "core/pipeline/scan_measures.h"
#include "ui/jobs/job_slot.h"

#include <optional>

namespace espalier {

class PipelinePanel;
class PlantDocument;

/// Measures in the background what the scan is like, and shows it in the panel of the pipeline.
class MeasureFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  MeasureFlow(PlantDocument& document, JobQueue& queue, PipelinePanel& pipeline);

  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }

private:
  void measure();
  void show();

  PlantDocument& document_;
  PipelinePanel& pipeline_;
  JobSlot job_;
  std::optional<ScanMeasures> measures_;
};

} // namespace espalier
