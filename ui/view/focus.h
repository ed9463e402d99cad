#pragma once

#include "core/skeleton/skeleton.h"
#include "ui/view/camera.h"
#include "ui/view/close_look.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace espalier {

/// What one looks at closely: what is neither near it in depth nor of its branch steps back.
struct Focus {
  Eigen::AlignedBox3d box;    // about it [L], frame of the file; not empty
  std::vector<NodeId> branch; // the axes it is on and those that bear them, in order: stay whole

  bool operator==(const Focus& other) const {
    return box.min() == other.box.min() && box.max() == other.box.max() && branch == other.branch;
  }
};

/// @param sight not empty, of nodes of `skeleton`
[[nodiscard]] Focus focusOn(const Skeleton& skeleton, const Sight& sight);

/// How far things step back by their depth, as seen from a camera.
///
/// As far as that where the focus is a fifth of the height of the screen or more; less as one moves
/// off it, and not at all under a twelfth, nor where it is behind the eye or beside what is
/// seen: there one looks at the plant again.
class FocusDepths {
public:
  FocusDepths() = default; // nothing steps back
  /// @param strength [0, 1]: how far
  FocusDepths(const Focus& focus, double strength, const Camera& camera);

  /// How far a depth [L] is stepped back, in [0, 1].
  [[nodiscard]] double outOfFocus(double depth) const;
  /// Whether a place hides nothing of what is in focus, though it is before it: it is drawn behind
  /// all, and not picked. Nothing is where hardly anything is pale.
  [[nodiscard]] bool isPassed(double depth) const {
    return strength_ >= leastPassed && depth < nearest_ &&
           outOfFocus(depth) >= 0.5 * strength_; // as isPassed() of focus_shader.h
  }
  static constexpr double leastPassed = 0.3; // strength
  /// Nearest and farthest depth in focus, over which depth things step back, and how far: for
  /// shaders (focus_shader.h).
  [[nodiscard]] Eigen::Vector4f forShaders() const;

  bool operator==(const FocusDepths&) const = default;

private:
  double nearest_ = 0;
  double farthest_ = 0;
  double reach_ = 1;
  double strength_ = 0;
};

} // namespace espalier
