#pragma once

#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"
#include "core/surface/convex_hull.h"

#include <QTimer>

#include <optional>
#include <vector>

namespace espalier {

class ActionSet;
class Editing;
class PlantDocument;
class PlantView;

/// The convex hulls of branches: each is about the points of what its node carries, and belongs to
/// the plant as the value of a feature of the node, its volume. They are shown as they are now, and
/// follow every edit; the volume is what it was when it was asked for.
class HullFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PlantView& view;
    ActionSet& actions;
    const Editing& editing;
    ScanDistances& distances;
  };
  explicit HullFlow(const Parts& parts);

  static constexpr const char* feature = "hull_volume"; // [L^3]

private:
  using Hulls = std::vector<std::optional<ConvexHull>>;
  void wrap();
  void unwrap();
  void follow(); // an edit, or other points
  void work();
  void take(const Hulls& hulls);
  void keepVolumes(const Hulls& hulls);
  void show(const Hulls& hulls);
  void refreshEnabled();
  [[nodiscard]] std::vector<NodeId> chosen() const;

  Parts parts_;
  std::vector<NodeId> asked_; // to be given a hull
  std::vector<NodeId> nodes_; // of the hulls that are being made, or shown
  QTimer timer_;
  JobSlot job_{parts_.queue, JobPriority::asked};
  bool isJobOutdated_ = false;
};
} // namespace espalier
