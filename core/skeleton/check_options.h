#pragma once

#include <numbers>

namespace espalier {

/// From where on something is reported as a finding. None is a length: what depends on the size of
/// the plant is in spacings of its points, radii, or lengths of edges. core/pipeline/check_table.h
/// has their names, ranges and help.
struct CheckOptions {
  double sharpTurn = std::numbers::pi / 2; // [rad] between two edges of an axis
  double branchTurn =
      2 * std::numbers::pi / 3; // [rad] of a branch from its bearer, or its first edge
  double shortEdge = 1e-3;      // of the mean length of an edge: shorter ones have no length
  double duplicateShare = 0.1;  // of its length: how near the ends of a duplicate lie
  double touch = 1;             // spacings: axes that are nearer touch, however thin they are
  double detour = 8;            // sums of radii along the plant: on a shorter path all wood touches
  double pointReach = 4;        // spacings from the surface: farther points are unexplained
  double clusterGap = 3;        // spacings between points of one cluster
  int clusterSize = 30;         // points: smaller clusters are strays
  double emptyReach = 6;        // spacings from the surface: edges with no points there are empty
  double ownBeside = 2;         // spacings from other wood: what is nearer to it is of that wood
  double ownReach = 4;          // spacings from the surface: where a branch has its own points
  int ownCount = 3;             // points there: fewer are strays
  double ownLength = 3; // spacings that a branch may begin with and have no points of its own
};

} // namespace espalier
