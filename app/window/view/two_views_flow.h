#pragma once

#include "app/window/frame/window_part.h"

#include <Eigen/Geometry>

class QAction;
class QActionGroup;
class QSettings;
class QSplitter;

namespace espalier {

class ActionSet;
class Editing;
class PlantView;
struct Camera;

/// A second view of the plant beside the first, on request: from the side, from the same direction,
/// or from wherever one likes. All tools work in both.
class TwoViewsFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  struct Parts {
    PlantView& view;  // the first
    QSplitter& place; // which it is in
    ActionSet& actions;
    Editing& editing;
    QSettings& settings;
  };
  explicit TwoViewsFlow(const Parts& parts);
  ~TwoViewsFlow() override;

  [[nodiscard]] PlantView* second() const { return second_; } // null: there is one view
  /// Does a view show all of the plant, while the other one looks closely?
  [[nodiscard]] bool showsWhole(const PlantView& view) const {
    return link_ == Link::whole && &view == second_;
  }

private:
  /// Where the second view looks from.
  enum class Link { side, same, free, whole };
  void addActions();
  void setTwo(bool areTwo);
  void setLink(Link link);
  [[nodiscard]] bool isLinked() const { return link_ == Link::side || link_ == Link::same; }
  void shareWidth();
  /// Moves `follower` to where a view is that looks from `camera`, turned about the up axis.
  void follow(PlantView& follower, const Camera& camera, double turn);
  void linkFirst(); // the second follows the first

  Parts parts_;
  QActionGroup* links_;
  Link link_ = Link::side;
  PlantView* second_ = nullptr; // owned by the place
  bool isFollowing_ = false;
  Eigen::AlignedBox3d framed_; // the plant, as the second view showed all of it [L]
};

} // namespace espalier
