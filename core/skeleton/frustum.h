#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <vector>

namespace espalier {

/// An edge as a body: the radius goes evenly from one end to the other.
struct Frustum {
  Eigen::Vector3d from;  // [L], at the parent
  Eigen::Vector3d to;    // [L]
  double fromRadius = 0; // [L]
  double toRadius = 0;   // [L]

  [[nodiscard]] double length() const { return (to - from).norm(); } // [L]
  [[nodiscard]] double lateralArea() const;                          // [L^2]
  [[nodiscard]] double volume() const;                               // [L^3]
  [[nodiscard]] Eigen::AlignedBox3d box() const;       // [L], about a ball at each end, too
  [[nodiscard]] Eigen::AlignedBox3d centerBox() const; // [L], about the center line

  // A share of the center line is 0 at `from` and 1 at `to`.
  [[nodiscard]] Eigen::Vector3d at(double share) const { return from + share * (to - from); }
  [[nodiscard]] double radiusAt(double share) const { // [L]
    return fromRadius + share * (toRadius - fromRadius);
  }
  /// Of the place of the center line nearest to another; 1 without length.
  [[nodiscard]] double nearestShare(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d along = to - from;
    const double squared = along.squaredNorm();
    return squared > 0 ? std::clamp(along.dot(place - from) / squared, 0.0, 1.0) : 1;
  }

  bool operator==(const Frustum&) const = default;
};

/// The frustum of the edge from a node to its parent.
///
/// A successor takes up the radius of its parent. A branch has its own from there on, and so has an
/// edge from a parent without a radius: it is a cylinder. A root that carries nothing is a ball;
/// one that carries something has no body of its own: none. pre: contains(id)
[[nodiscard]] std::optional<Frustum> frustumOf(const Skeleton& skeleton, NodeId id);

/// From the parent to the node, without radii; of a root, without length. pre: contains(id)
[[nodiscard]] Frustum centerLine(const Skeleton& skeleton, NodeId id);

/// An edge with its frustum.
struct EdgeBody {
  NodeId node; // the upper end
  Frustum body;
};

/// Of all edges that have one, parents first.
[[nodiscard]] std::vector<EdgeBody> bodiesOf(const Skeleton& skeleton);

/// Where two center lines are nearest to each other.
struct NearestShares {
  double distance = 0; // [L], between the center lines
  double a = 0;        // share of the first, in [0, 1]
  double b = 0;        // likewise, of the second
};

/// Source: C. Ericson, "Real-Time Collision Detection", 2005, 5.1.9.
[[nodiscard]] NearestShares nearestShares(const Frustum& a, const Frustum& b);

} // namespace espalier
