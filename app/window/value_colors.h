#pragma once

#include "app/window/scan_distances.h"
#include "ui/view/point_look.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

class ActionSet;
class PlantDocument;
class PlantView;
class ViewOptions;

/// Colors nodes by what they are, and points by how far they are from the skeleton or how far
/// contraction moved them, as the options of the view say. Follows every edit and every preview.
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

  /// What is contracted in place of the contracted points of the document.
  /// @param contracted all points of the scan; null: those of the document
  void setPreviewed(std::shared_ptr<const Eigen::Matrix3Xf> contracted);

private:
  void choose();
  void show();
  void colorNodes();
  void colorPoints();
  [[nodiscard]] std::optional<PointValues> pointValues() const; // none: not colored by these
  [[nodiscard]] PointValues distances() const;
  [[nodiscard]] PointValues displacements(const Eigen::Matrix3Xf& contracted) const;
  /// @param known values of the nodes, not empty
  [[nodiscard]] Legend legendOf(const QString& id, std::vector<double> known) const;

  Parts parts_;
  QString nodeColor_;  // the id of the action chosen
  QString pointColor_; // likewise
  std::shared_ptr<const Eigen::Matrix3Xf> previewed_;
  bool hasPointValues_ = false;
  QTimer timer_;
};

} // namespace espalier
