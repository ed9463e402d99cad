#pragma once

#include "core/skeleton/own_points.h"
#include "core/skeleton/points_expected.h"

namespace espalier {

/// Where wood without points is likelier to be hidden from the scanner than wrong. Refers to all it
/// is made of. Build O(n log n + N).
class UnseenWood {
public:
  UnseenWood(const Skeleton& skeleton, const PointDistances& distances, const SpatialIndex& index,
             double spacing, const CheckOptions& options);

  /// Of edges or a branch without points: wood as thick has few points along such a length, at most
  /// `fewestExpected`; or an axis that is seen goes on into the stretch, and out of it if it does
  /// not end there, turning by `hiddenTurn` at most. A stretch at an end may be as long as the axis
  /// before it.
  [[nodiscard]] bool mayBeHidden(const Finding& finding) const;

private:
  [[nodiscard]] bool goesOn(const Finding& finding) const;
  [[nodiscard]] bool turns(NodeId id) const; // at the beginning of the edge to it
  [[nodiscard]] bool isSeenBefore(const Finding& finding) const;

  const Skeleton& skeleton_;
  CheckOptions options_;
  OwnPoints own_;
  PointsExpected expected_;
};

} // namespace espalier
