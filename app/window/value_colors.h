#pragma once

#include "app/window/scan_distances.h"
#include "ui/view/color_map.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace espalier {

class ActionSet;
class PlantDocument;
class PlantView;
class ViewOptions;

/// Colors nodes by what they are, and points by how far they are from the skeleton, as the options
/// of the view say. Follows every edit.
class ValueColors : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    ViewOptions& options;
    ScanDistances& distances;
  };
  explicit ValueColors(const Parts& parts);

private:
  void choose();
  void show();
  void colorNodes();
  void colorPoints();
  [[nodiscard]] Legend legendOf(const QString& id,
                                const std::vector<std::optional<double>>& values) const;

  Parts parts_;
  QString nodeColor_; // the id of the action chosen
  bool isByDistance_ = false;
  bool hasPointValues_ = false;
  QTimer timer_;
};

} // namespace espalier
