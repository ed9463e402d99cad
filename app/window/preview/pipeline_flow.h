#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"

namespace espalier {

class PipelinePanel;
class PlantDocument;
class ReconstructFlow;

/// The pipeline dock, whose options a project keeps, with those the plant was made with.
class PipelineFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PipelinePanel& panel;
    ReconstructFlow& reconstruct;
    PanelDock::Parts window;
  };
  explicit PipelineFlow(const Parts& parts);

signals:
  void shown(); // the options of a project

private:
  void keepOptions();

  Parts parts_;
};

} // namespace espalier
