#pragma once

#include "ui/jobs/latest_job.h"

#include <QObject>

namespace espalier {

class PipelinePanel;
class PlantDocument;

/// Tells the panel of the pipeline how dense the points of the scan lie, where radii follow it.
class DensityFlow : public QObject {
  Q_OBJECT

public:
  /// Both must outlive it.
  DensityFlow(PlantDocument& document, PipelinePanel& pipeline);

  void refresh();
  [[nodiscard]] bool isBusy() const { return job_.isBusy(); }

private:
  PlantDocument& document_;
  PipelinePanel& pipeline_;
  LatestJob job_;
};

} // namespace espalier
