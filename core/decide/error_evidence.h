#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/point_distances.h"
#include "core/skeleton/review_walk.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// What the points and the shape of a plant say of a piece of its skeleton: whether it stands where
/// wood is, and is attached to what bears it. Lengths in point spacings. Radii count only where the
/// surface is that distances are taken from.
struct ErrorEvidence {
  double length = 0;      // of the piece
  double whole = 0;       // of the unbranched run of nodes that it is part of
  double carried = 0;     // of all that is attached above it
  double points = 0;      // whose surface it is, nearest and within the reach of the checks
  double scatter = 0;     // mean distance of these to the surface, either side of it
  double unexplained = 0; // points nearest to it that lie farther from it than that
  double inAir = 0;       // share of its length that no point is near
  double withoutOwn = 0;  // how much of its beginning has no points of its own; as a finding has it
  double beside = 0;      // from its middle to other wood, but for what it is connected to
  double radius = 0;      // mean
  double turn = 0;        // cosine between it and the wood below it
  bool branches = false;  // it begins beside what goes on below it
  double findings = 0;    // of its shape: crossings, turns, duplicates, separate pieces
  double end = 0;     // logarithm of the odds that the end it is part of is a shoot; 0: is of none
  bool isEnd = false; // it is part of one
  double gap = 0;     // how probable it is that the gap it bridges is bridged otherwise; 0: no gap
};

/// How long the pieces are at most that errors are rated by [L]: 30 spacings.
[[nodiscard]] double ratedLength(const PlantScale& scale);

/// Of each piece of a plant what speaks for an error.
///
/// @param pieces    neighboring nodes of one axis each, as stretches() has them
/// @param distances of the points of the scan to `skeleton`
/// @param index     of the positions of their cloud
/// @param scale     of the plant; its spacing is > 0
/// @param up        length 1
/// Uses all threads, deterministic. Time O(N log N + length / spacing log N).
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<ErrorEvidence>
errorEvidence(const Skeleton& skeleton, const std::vector<Stretch>& pieces,
              const PointDistances& distances, const SpatialIndex& index, const PlantScale& scale,
              const Eigen::Vector3d& up, const Progress& progress = {});

} // namespace espalier
