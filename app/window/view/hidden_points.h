#pragma once

#include "app/window/frame/window_part.h"

#include <QTimer>

namespace espalier {

class PlantDocument;
class PointStates;
class ScanDistances;
class ShownFlow;

/// Hides the points that belong to nodes which are hidden: those to which the wood of one of these
/// is the nearest. Follows every edit.
class HiddenPoints : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    ShownFlow& shown;
    ScanDistances& distances;
    PointStates& states;
  };
  explicit HiddenPoints(const Parts& parts);

private:
  void refresh();

  Parts parts_;
  QTimer timer_; // many edits are shown at once
};

} // namespace espalier
