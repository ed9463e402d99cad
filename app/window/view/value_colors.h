#pragma once

#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"
#include "ui/view/point_look.h"

#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

class ActionSet;
class OrganFlow;
class PlantDocument;
class PlantView;
class ViewOptions;

/// Colors nodes by what they are, and points by how far they are from the skeleton, how far
/// contraction moved them or what they lie on, as the options of the view say. Follows every edit
/// and every preview.
class ValueColors : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    ViewOptions& options;
    ScanDistances& distances;
    OrganFlow& organs;
  };
  explicit ValueColors(const Parts& parts);

  /// What is contracted in place of the contracted points of the document.
  /// @param contracted null: those of the document
  /// @param points which points of the scan these are, ascending; empty: all
  void setPreviewed(std::shared_ptr<const Eigen::Matrix3Xf> contracted,
                    std::vector<Eigen::Index> points);
  void setDark(bool isDark);

private:
  void choose();
  void show();
  void colorNodes();
  void colorPoints();
  [[nodiscard]] std::optional<PointValues> pointValues() const; // none: not colored by these
  [[nodiscard]] PointValues distances() const;
  [[nodiscard]] std::optional<PointValues> organs() const;
  /// @param lengths one per point of the scan [L]; not a number: not known
  [[nodiscard]] PointValues shownDisplacements(std::vector<float> lengths) const;
  [[nodiscard]] std::vector<float> displacementsInPart() const; // of what is previewed
  /// @param known values of the nodes, not empty
  [[nodiscard]] Legend legendOf(const QString& id, std::vector<double> known) const;

  Parts parts_;
  QString nodeColor_;  // the id of the action chosen
  QString pointColor_; // likewise
  std::shared_ptr<const Eigen::Matrix3Xf> previewed_;
  std::vector<Eigen::Index> previewedPoints_; // as of setPreviewed()
  bool hasPointValues_ = false;
  bool isDark_ = false;
  QTimer timer_;
};

} // namespace espalier
