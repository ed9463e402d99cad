#pragma once

#include "core/cloud/organ.h"
#include "core/skeleton/frustum.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace espalier {

/// The solid of one edge: its frustum, closed by a ball at the upper end.
struct EdgeSolid : Frustum {
  std::optional<NodeId> node; // the upper end; none: of a short shoot or a petiole
  Organ organ = Organ::wood;
};

struct Ray {
  Eigen::Vector3d origin;    // [L]
  Eigen::Vector3d direction; // unit
};

struct WoodHit {
  double range = 0;           // [L] along the ray, > 0
  Eigen::Vector3d normal;     // unit, out of the wood
  std::optional<NodeId> node; // whose edge was hit, if any
  Organ organ = Organ::wood;
};

/// The solid that a skeleton with radii stands for, edge by edge, parents first. The first edge of
/// a branch starts on the axis of its parent, inside the parent's wood. Edges of no length are
/// balls.
/// @throws Error if a position is not finite, or a node with a parent has no radius
[[nodiscard]] std::vector<EdgeSolid> woodOf(const Skeleton& plant);

/// Where a ray enters a solid, if it does. The frustum is open at its lower end, which lies in
/// other wood or, at a root, on the ground.
[[nodiscard]] std::optional<WoodHit> hit(const EdgeSolid& solid, const Ray& ray);

/// Distance [L] from a place to the surface of a solid; negative inside.
[[nodiscard]] double signedDistance(const EdgeSolid& solid, const Eigen::Vector3d& place);

[[nodiscard]] inline Eigen::AlignedBox3d boundsOf(const EdgeSolid& solid) {
  return solid.box();
}

} // namespace espalier
