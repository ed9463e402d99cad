#pragma once

#include "core/skeleton/finding.h"
#include "core/skeleton/review_walk.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// Where a reviewer stops: at nodes, or at points that have no wood.
struct ReviewStop {
  std::vector<NodeId> nodes;              // each with the edge to its parent; empty: at points
  std::vector<std::size_t> clusters = {}; // of points: which, as they are given
  double wrong = 0;                       // [L] how much of it is probably wrong, or missed
  double length = 0;                      // [L] of its edges
  bool isClean = false;                   // none of its edges is risky
  bool isDoubtful = false; // at points that one has left in doubt: as it is set, not found

  [[nodiscard]] bool isAtPoints() const { return !clusters.empty(); }
  bool operator==(const ReviewStop&) const = default;
};

/// In which order one walks.
enum class WalkOrder : std::uint8_t { alongPlant, byExpectedError };

/// What is known of errors before a review.
struct ExpectedErrors {
  std::vector<double> ofEdges; // probabilities, by id of the upper node; later ids are not known
  std::vector<Finding> clusters = {}; // of points without wood (pointsWithoutWood())

  bool operator==(const ExpectedErrors&) const = default;
};

/// From which probability of an error on an edge is risky, where it is not known in any case.
///
/// On simulated plants that the odds were not fitted on, 28 % of the length is at or above it, with
/// 78 % of what is wrong (espalier_fit_errors).
inline constexpr double riskyFrom = 0.1;

/// The stops of a review: each node is in one.
///
/// Along the plant, axis by axis as axesInWalkOrder() has them. What is clean of an axis is taken
/// whole, unless it is over two of the longest stretches across: so it is drawn not much smaller
/// than a stretch. What is risky is taken in parts no longer than one stretch. A clean part that is
/// shorter than half of a stretch goes with what is risky beside it. A branch that is clean with
/// all that it carries, two stretches long together at most, goes with the first clean stop of the
/// axis that bears it in which both are no longer and no wider than that, or begins one; a branch
/// that is risky in part likewise, by one stretch, with what is risky. Clusters of points without
/// wood that together are no wider than one stretch are one stop, behind that with the node that
/// the first of them is nearest to.
///
/// By expected error, those with the most length that is probably wrong come first; of clusters
/// that is a share of how far they reach, as missed wood has it in simulated scans.
/// @param errors  null: nothing is known, and all is taken in stretches, along the plant
/// O(N log N), and for each axis branches times stops.
[[nodiscard]] std::vector<ReviewStop> reviewStops(const Skeleton& skeleton,
                                                  const ExpectedErrors* errors,
                                                  WalkOrder order = WalkOrder::alongPlant);

/// The stop that `id` is in; none: the node is gone. O(N).
[[nodiscard]] std::optional<std::size_t> stopOf(const std::vector<ReviewStop>& stops, NodeId id);

enum class WalkTo : std::uint8_t {
  anyStop,
  toDo,        // in part at least, or points
  notReviewed, // likewise: to do or doubtful
  openEnd,     // an apex that is not reviewed
  branching    // a node with several children that is not reviewed
};
enum class WalkDirection : std::uint8_t { forward, backward };

/// The next stop of this kind after `from`, and from the other end on once the walk is through;
/// `from` itself comes last. None: there is none of the kind. O(N).
/// @param from  none: before the first, or behind the last if the direction is backward
[[nodiscard]] std::optional<std::size_t> walk(const Skeleton& skeleton,
                                              const std::vector<ReviewStop>& stops,
                                              std::optional<std::size_t> from, WalkTo to,
                                              WalkDirection direction = WalkDirection::forward);

} // namespace espalier
