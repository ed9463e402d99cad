#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/clip.h"
#include "ui/view/focus.h"
#include "ui/view/plant_state.h"
#include "ui/view/point_colors.h"
#include "ui/view/point_hierarchy.h"
#include "ui/view/point_look.h"
#include "ui/view/shown_scan.h"
#include "ui/view/skeleton_glyphs.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// Points that are drawn. `revision` grows when they are replaced: the renderer then uploads anew.
struct DrawnPoints {
  std::shared_ptr<const Eigen::Matrix3Xf> positions; // about the origin of the scene; null: none
  std::uint64_t revision = 0;

  void set(std::shared_ptr<const Eigen::Matrix3Xf> replacement);
  [[nodiscard]] Eigen::Index size() const { return positions ? positions->cols() : 0; }
};

/// Points of one layer, which can be picked as well.
struct PointLayer : DrawnPoints {
  PointHierarchy boxes;
  double spacing = 0; // median distance of a point to the nearest at another place [L]
  bool visible = true;

  void set(std::shared_ptr<const Eigen::Matrix3Xf> replacement);
};

/// A PlantState as it is drawn on its side of the divider.
struct OtherState {
  bool isShown = false;
  QString name;
  DrawnPoints contracted;
  PointHierarchy boxes;                            // of these
  std::shared_ptr<const Eigen::Matrix3Xf> scanned; // where these points come from; may be null
  std::vector<Eigen::Index> points;                // which of the cloud they are; may be empty
  SkeletonGlyphs skeleton;
  bool replacesPoints = false;
  std::optional<Ball> within;
};

/// A ShownScan as it is drawn.
struct MovedScan : DrawnPoints { // about the origin of its own cloud
  ShownScan shown;               // without a cloud: none
  PointHierarchy boxes;
  Eigen::AlignedBox3d box;         // of the cloud without far points [L], its own frame
  std::uint64_t colorRevision = 0; // grows when its points are to be colored anew

  [[nodiscard]] bool isShown() const { return positions != nullptr; }
  [[nodiscard]] bool isBehind() const { return shown.foreground == Foreground::fixed; }
  [[nodiscard]] bool hidesFixed() const { return shown.foreground == Foreground::moved; }
};

/// What the view shows. Read by the renderer, the overlay and the picker; knows none of them.
struct Scene {
  std::shared_ptr<const PointCloud> cloud; // null: none
  PointSet leftOut;             // of the cloud, which are set aside: they count for no measure
  Eigen::AlignedBox3d plantBox; // of the cloud without these and far points; empty: it has none
  PointLayer points;
  PointLayer contracted;
  SkeletonGlyphs skeleton;
  SkeletonGlyphs reference; // what it is compared with; drawn, never picked
  MovedScan moved;          // over the cloud
  bool skeletonVisible = true;
  bool referenceVisible = true;
  std::array<OtherState, 2> others; // in place of the plant, by the side of the divider

  /// How far contracted points have gone from where they were scanned, in [0, 1]; they are then
  /// drawn in place of the points. None: each layer is where it is.
  std::optional<double> blend;
  bool areSomeAtRest = false;      // contracted points that lie where they were scanned
  bool displacementsShown = false; // a line from where a point was scanned to where it is now

  PointColor pointColor = PointColor::height;
  std::optional<Legend> colorLegend;      // of `cloud` by `pointColor`, as given
  std::optional<ValueRange> seenRange;    // of colorLegend, in place of the usual one (seenRange())
  std::optional<PointValues> pointValues; // color `cloud` in place of `pointColor`
  std::shared_ptr<const std::vector<PointState>> pointStates; // of `cloud`; null: all normal
  ColorScales colorScales;
  std::uint64_t colorRevision = 0; // grows when points are to be colored anew
  std::uint64_t stateRevision = 0; // likewise, with it, when this is for their states alone
  int pointSize = 2;               // [logical pixels]
  bool showRadii = false;
  UpAxis up = UpAxis::z; // along which heights are
  bool dark = false;
  Clip clip;
  double depthFade = 0;       // how far the back of the plant steps back, in [0, 1]
  std::optional<Focus> focus; // none: all of the plant is looked at
  double focusFade = 0.7;     // how far what is out of focus steps back, in [0, 1]

  void setCloud(std::shared_ptr<const PointCloud> replacement);
  void setLeftOut(const PointSet& aside); // of the cloud, until setCloud()
  void setContracted(std::shared_ptr<const Eigen::Matrix3Xf> positions);
  void setSkeleton(const Skeleton& replacement);
  void setReference(const Skeleton& replacement);                   // empty: none
  void setOther(Side side, const std::optional<PlantState>& state); // none: the plant itself
  void setMovedScan(const std::optional<ShownScan>& scan);          // none: nothing
  void setPointColor(PointColor color);
  void setSeenRange(std::optional<ValueRange> range); // until setPointColor()
  void setPointStates(std::shared_ptr<const std::vector<PointState>> states);
  void setPointValues(std::optional<PointValues> values);
  void setNodeColors(std::optional<NodeColors> colors);
  void setReferenceColors(std::optional<NodeColors> colors);
  void setColorScales(const ColorScales& scales);
  void setDark(bool isDark);
  void setUp(UpAxis axis);
  void setFocus(std::optional<Focus> replacement);
  [[nodiscard]] FocusDepths focusDepths(const Camera& camera) const;

  /// What points and nodes are colored by, on the scale that is chosen; none: not by value.
  [[nodiscard]] std::optional<Legend> pointLegend() const;
  [[nodiscard]] std::optional<Legend> movedLegend() const; // of the points of the other scan
  [[nodiscard]] std::optional<Legend> nodeLegend() const;
  [[nodiscard]] std::optional<Legend> referenceLegend() const;
  [[nodiscard]] std::optional<Legend> legendOf(const OtherState& other) const; // its nodes'

  [[nodiscard]] const OtherState& other(Side side) const {
    return others[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] OtherState& other(Side side) { return others[static_cast<std::size_t>(side)]; }
  /// Is the plant itself, not another state of it, drawn here?
  /// @param divider of the view, as PlantView::setDivider
  /// @param across  from its left, in [0, 1]
  [[nodiscard]] bool showsPlant(const Eigen::Vector3d& place, double across, double divider) const;

  /// Are points drawn here where they were scanned, as long as their layer is?
  [[nodiscard]] bool showsScanned(const Eigen::Vector3d& place, double across,
                                  double divider) const;

  /// Is a point of the cloud drawn, as long as its layer is?
  [[nodiscard]] bool isPointShown(Eigen::Index point) const {
    return !pointStates || (*pointStates)[static_cast<std::size_t>(point)] != PointState::hidden;
  }

  /// Likewise, of a contracted point: one that was left out, and so lies where it was scanned, is
  /// shown there alone.
  [[nodiscard]] bool isContractedShown(Eigen::Index point) const {
    return contracted.size() != points.size() ||
           (isPointShown(point) && !isContractedAtRest(point));
  }
  /// pre: there are as many contracted points as points
  [[nodiscard]] bool isContractedAtRest(Eigen::Index point) const {
    return contracted.positions->col(point) == points.positions->col(point);
  }

  /// From the points of the other scan, as they are kept, to those of the cloud. pre: it is shown
  [[nodiscard]] Eigen::Isometry3d movedPlacement() const;

  /// What is shown from a camera.
  [[nodiscard]] ClipVolume clipVolume(const Camera& camera) const;

  /// What is drawn from a camera [L]. Far points are, from far away: near the plant they would
  /// leave it no depth.
  [[nodiscard]] DepthRange depths(const Camera& camera) const;

  /// What float coordinates are counted from [L]: the cloud's origin, else that of the glyphs.
  [[nodiscard]] Eigen::Vector3d origin() const;
  /// Encloses all there is, shown or not [L], frame of the file, but for points set aside and the
  /// few far points of the cloud: a plant beside one would be a dot. Empty if there is nothing.
  [[nodiscard]] Eigen::AlignedBox3d bounds() const;
  /// All nodes and an even sample of these points that are not hidden [L], frame of the file: what
  /// a camera has to frame to show the whole, tighter than the bounds.
  [[nodiscard]] std::vector<Eigen::Vector3d> outline() const;

private:
  void measurePlant();
  [[nodiscard]] Eigen::AlignedBox3d boundsWithin(const Eigen::AlignedBox3d& within) const;
  void recolorNodes();
  void recolorNodes(OtherState& shown) const;
};

} // namespace espalier
