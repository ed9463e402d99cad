#pragma once

#include <numbers>

namespace espalier {

/// From where on something is reported as a finding. None is a length: what depends on the size of
/// the plant is in spacings of its points, in radii, or in lengths of edges; what is said to be in
/// units is in spacings, or more where the points scatter wide or the skeleton is drawn less
/// exactly (exactness() in core/skeleton/checks_of_scan.h). core/pipeline/check_table.h has their
/// names, ranges and help.
///
/// What says how far off, how long, how many or how sharp something is was chosen on 24 bare plants
/// of scannedPlant(0) and on, and 14 of noisyPlant(0) and on (tests/bench/finding_table.cpp).
struct CheckOptions {
  double sensitivity = 1; // above: findings where limits are that much lower; see atSensitivity()
  double scatter = 0;     // spacings: of the points normal to the wood. Measured, not set
  double sharpTurn = std::numbers::pi / 2; // [rad] between two edges of an axis
  double branchTurn =
      2 * std::numbers::pi / 3; // [rad] of a branch from its bearer, or its first edge
  double shortEdge = 1e-3;      // of the mean length of an edge: shorter ones have no length
  double duplicateShare = 0.1;  // of its length: how near the ends of a duplicate lie
  double touch = 1;             // spacings: axes that are nearer touch, however thin they are
  double detour = 8;            // sums of radii along the plant: on a shorter path all wood touches
  double thicker = 0.1;         // of the radius of the parent, that a node may be thicker
  double pointReach = 3;        // units from the surface: farther points are unexplained
  double clusterGap = 3;        // spacings between points of one cluster
  int clusterSize = 6;          // points: smaller clusters are strays
  double clusterRise = 2;       // reaches of edges: how far the farthest point of a cluster is off
  int largeCluster = 30;        // points: larger clusters may be nearer
  double emptyReach = 6;        // spacings from the surface: edges with no points there are empty
  double ownBeside = 2;         // spacings from other wood: what is nearer to it is of that wood
  double ownReach = 4;          // spacings from the surface: where a branch has its own points
  int ownCount = 3;             // points there: fewer are strays
  double ownLength = 3;      // spacings that a branch may begin with and have no points of its own
  double fewestExpected = 8; // points that wood as thick has along an empty stretch
  double hiddenTurn = std::numbers::pi / 4; // [rad] that wood which is hidden may turn by
  double besideUnits = 2.5;                 // that wood may lie beside its points
  double besideRadii = 0.5;                 // likewise, radii of the wood
  double footSpacings = 6;                  // that points of a stem may go on below its root
  double footRadii = 1;                     // likewise, radii of the stem
};

/// The limits at their sensitivity: at 2, half as many points, half as long a stretch and half as
/// far off are reported, and turns by half the tangent of half the angle. What says which points
/// are whose stays. Sensitivity is 1 in the result.
/// pre: sensitivity > 0
[[nodiscard]] CheckOptions atSensitivity(const CheckOptions& options);

} // namespace espalier
