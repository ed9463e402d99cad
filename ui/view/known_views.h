#pragma once

#include "ui/view/camera.h"
#include "ui/view/close_look.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <deque>
#include <optional>

namespace espalier {

/// From where parts of a plant were looked at closely: what one comes back to is seen as before,
/// from wherever one comes.
class KnownViews {
public:
  /// What else the view of a sight depends on.
  struct Situation {
    Eigen::AlignedBox3d place; // of its nodes, which may have been moved since [L]
    Projection projection;
    UpAxis up;
    double aspect; // of the screen
  };

  [[nodiscard]] std::optional<Camera> find(const Sight& sight, const Situation& now) const;
  void keep(const Sight& sight, const Situation& now, const Camera& camera);
  void forget() { known_.clear(); }

private:
  struct Known {
    Sight sight;
    Situation situation;
    Camera camera;
  };
  std::deque<Known> known_; // the latest last
};

} // namespace espalier
