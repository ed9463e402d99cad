#pragma once

#include "app/window/frame/window_part.h"
#include "core/graph/find_root.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

class ActionSet;
class Editing;
class PipelinePanel;
class PlantDocument;
class PlantView;

/// How the plant stands in its file, chosen before it is reconstructed: which axis points up, and
/// where the root is. The view follows: it turns the plant upright, and marks the root.
class StandFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    PipelinePanel& pipeline;
    ActionSet& actions;
    Editing& editing; // whose tool picks the root
  };
  explicit StandFlow(const Parts& parts);

private:
  void addActions();
  void noteRoot();
  void showUp();
  void showRoot();
  void refresh();

  Parts parts_;
};

} // namespace espalier
