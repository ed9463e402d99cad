#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace espalier {

/// The wood around one edge: a frustum between its two nodes, closed by a ball at the upper one.
struct WoodPiece {
  Eigen::Vector3d from;       // [L], the parent
  Eigen::Vector3d to;         // [L], the node
  double fromRadius = 0;      // [L]
  double toRadius = 0;        // [L]
  std::optional<NodeId> node; // whose edge to its parent this is; none: of a short shoot
};

struct Ray {
  Eigen::Vector3d origin;    // [L]
  Eigen::Vector3d direction; // unit
};

struct WoodHit {
  double range = 0;           // [L] along the ray, > 0
  Eigen::Vector3d normal;     // unit, out of the wood
  std::optional<NodeId> node; // whose edge was hit, if any
};

/// The solid that a skeleton with radii stands for, a piece per edge, parents first.
///
/// A successor takes up the radius of its parent; a branch has its own radius from the axis of its
/// parent on, so that its first piece starts inside the parent's wood. Edges of no length are
/// balls.
/// @throws Error if a position is not finite, or a node with a parent has no radius
[[nodiscard]] std::vector<WoodPiece> woodOf(const Skeleton& plant);

/// Where a ray enters a piece, if it does. The frustum is open at its lower end, which lies in
/// other wood or, at a root, on the ground.
[[nodiscard]] std::optional<WoodHit> hit(const WoodPiece& piece, const Ray& ray);

/// Distance [L] from a place to the surface of a piece; negative inside.
[[nodiscard]] double signedDistance(const WoodPiece& piece, const Eigen::Vector3d& place);

[[nodiscard]] double lateralArea(const WoodPiece& piece); // [L^2], of the frustum alone

[[nodiscard]] Eigen::AlignedBox3d boundsOf(const WoodPiece& piece); // [L]

} // namespace espalier
