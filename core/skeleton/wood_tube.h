#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>

namespace espalier {

/// The wood about one edge: a tube whose radius goes evenly from one end to the other.
struct WoodTube {
  Eigen::Vector3d from; // [L], at the parent
  Eigen::Vector3d to;   // [L]
  double fromRadius = 0;
  double toRadius = 0; // [L]

  [[nodiscard]] Eigen::AlignedBox3d centerBox() const; // [L], about the center line
  [[nodiscard]] double widest() const;                 // [L]
  bool operator==(const WoodTube&) const = default;
};

/// The tube of the edge from a node to its parent. A successor takes up the radius of its parent; a
/// branch has its own from there on. A root that carries nothing is a ball; one that carries
/// something has no tube of its own: none. pre: contains(id)
[[nodiscard]] std::optional<WoodTube> tubeOf(const Skeleton& skeleton, NodeId id);

/// Where two center lines are nearest to each other.
struct NearestOfTubes {
  double distance = 0; // [L], between the center lines
  double a = 0;        // share of the way along the first, in [0, 1]
  double b = 0;        // likewise, of the second
};

/// Source: C. Ericson, "Real-Time Collision Detection", 2005, 5.1.9.
[[nodiscard]] NearestOfTubes nearestOf(const WoodTube& a, const WoodTube& b);

/// The radius at a share of the way [L].
[[nodiscard]] inline double radiusAt(const WoodTube& tube, double share) {
  return tube.fromRadius + share * (tube.toRadius - tube.fromRadius);
}

} // namespace espalier
