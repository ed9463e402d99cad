#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/skeleton/skeleton_delta.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// A place where a skeleton differs from the first one.
struct Disagreement {
  std::size_t with = 1;                         // its number among the skeletons
  Difference kind = Difference::missed;         // the first being the result, it the reference
  double length = 0;                            // [L], as of a DifferingPart
  Eigen::Vector3d at = Eigen::Vector3d::Zero(); // where it begins [L]
};

/// What several skeletons of one plant agree on.
struct Consensus {
  /// Wood of the first that each other one has, where it has it. Nodes are numbered anew and have
  /// positions, radii and types alone. Wood that is attached elsewhere in one of them, or that what
  /// is not agreed on would bear, is a tree of its own.
  Skeleton agreed;
  std::vector<NodeId> nodes;        // of the first, by the ids of those of `agreed`
  std::vector<Disagreement> places; // by skeleton, of each the longest first
  std::vector<double> shares;       // of the length of each skeleton, that near all of the agreed
};

/// Finds on what wood several skeletons of one plant agree, as differences() sees them: that of the
/// first which all others have, within the tolerance, on the same path from the root. Wood that
/// another one has from its other end up, as where the roots are opposite, is wrongly attached.
/// Attachments are seen from both sides: wood that two attach elsewhere is one place, together with
/// what leads there in either. So which one is first decides where wood lies, and nothing else but
/// for wood that runs beside other wood within the tolerance.
///
/// @param plants    at least 2, in one frame: nothing is registered
/// @param tolerance [L], > 0
/// @throws as differences()
/// Deterministic. Time that of differences(), twice for each but the first and once more for each.
[[nodiscard]] Consensus consensusOf(std::span<const Skeleton> plants, double tolerance,
                                    const Progress& progress = {});

/// How far apart wood counts as the same unless another distance is given [L]: usualTolerance() of
/// the skeleton whose edges are longest.
[[nodiscard]] double usualDistance(std::span<const Skeleton> plants);

/// The first that is over nine times as large as the first of all, or as small: units of lengths
/// are ten times apart at least, and the wood of one lies near that of a far larger one wherever it
/// is. None: all are alike.
[[nodiscard]] std::optional<std::size_t> inOtherUnit(std::span<const Skeleton> plants);

/// The first skeleton of whose length not a hundredth is agreed on: it is of another plant, or
/// lies elsewhere. None: of all more is.
[[nodiscard]] std::optional<std::size_t> withoutAgreement(const Consensus& consensus);

/// Leaves of the first skeleton of a consensus what is agreed on, with all that it says of it, as
/// an edit; see Consensus::agreed.
/// pre: the editor's skeleton is as it was then
void keepAgreed(SkeletonEditor& editor, const Consensus& consensus);

} // namespace espalier
