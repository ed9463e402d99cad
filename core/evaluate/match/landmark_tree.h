#pragma once

#include "core/evaluate/match/segment_matches.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// A tip or a branching.
struct Landmark {
  Eigen::Vector3d position; // [L]
  bool isTip;
  std::optional<std::size_t> below; // the landmark it stands on, if any
  double length;                    // of the path from there, or from the root [L]
  double carried = 0;               // tips at or above it
};

/// The landmarks of a skeleton, each after the one it stands on.
[[nodiscard]] std::vector<Landmark> landmarksOf(const Skeleton& skeleton);

/// Pairs tips with tips and branchings with branchings, as landmarkPairs(). By landmark of
/// `result`.
[[nodiscard]] Partners partnersOf(const std::vector<Landmark>& result,
                                  const std::vector<Landmark>& reference, double distance);

/// The path down to the nearest landmark with a partner.
struct PathBelow {
  std::optional<std::size_t> landmark; // none: there is none below
  double length;                       // [L]
};
[[nodiscard]] std::vector<PathBelow> pathsBelow(const std::vector<Landmark>& landmarks,
                                                const Partners& partners);

} // namespace espalier
