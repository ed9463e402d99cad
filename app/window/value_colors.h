#pragma once

#include "app/window/scan_distances.h"
#include "ui/view/color_map.h"

#include <QObject>
#include <QTimer>

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
  /// @param known values of the nodes, not empty
  [[nodiscard]] Legend legendOf(const QString& id, std::vector<double> known) const;

  Parts parts_;
  QString nodeColor_; // the id of the action chosen
  bool isByDistance_ = false;
  bool hasPointValues_ = false;
  QTimer timer_;
};

} // namespace espalier
