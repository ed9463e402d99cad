#pragma once

#include "core/skeleton/skeleton.h"

#include <optional>
#include <vector>

namespace espalier {

/// The internode that leads to a node from its parent. Angles that have no meaning are none: those
/// of an internode without a length, or of a branch that goes along its axis.
struct Internode {
  double length = 0;                 // [L]
  std::optional<double> inclination; // from straight up, z [rad], in [0, pi]
  std::optional<double> turn;        // from the internode of the parent [rad], in [0, pi]

  // Where a branch begins on another axis, in the order of the branches along it:
  std::optional<double> azimuth;    // around the axis [rad], in [0, 2 pi)
  std::optional<double> divergence; // azimuth less that of the branch before [rad], in [0, 2 pi)
  std::optional<double> spacing;    // along the axis, from where the branch before is attached [L]
};

/// The internodes by the nodes they lead to; empty ones for roots and where there is no node.
///
/// The azimuth of a branch that leads from q to p is atan2(d.(t x u), d.u), where d = p - q, t is
/// the direction of the axis at q, from the node before q to the one after it, and u is
/// perpendicular to t: at the first node of the axis it is the direction of x (of y, if the axis
/// goes along x), and from there the least rotation carries it from node to node. Seen from the
/// apex of the axis, azimuths grow counterclockwise; on an axis that goes straight up they are
/// those around z, from x.
/// Time and memory O(N).
/// Source of the quantities: PlantScan3D's "Angle Estimation", which fits a line or curve to the
/// trunk instead.
[[nodiscard]] std::vector<Internode> internodes(const Skeleton& skeleton);

} // namespace espalier
