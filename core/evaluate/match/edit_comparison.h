#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/edit_distance.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <string>
#include <vector>

namespace espalier {

/// What the vertices of the compared trees stand for.
enum class EditUnit { node, segment, axis };

/// What it costs to take one part for another. Each part counts one, or its length.
enum class EditCost {
  topology,   // 1 to remove or insert; nothing to substitute: only what is attached to what counts
  attributes, // as `topology`, but parts differ by length, radius, order and direction
  length,     // its length to remove or insert; the difference of the lengths to substitute
  place,      // as `length`, and the distance of the centers in addition
  shape       // as `length`, but the Hausdorff distance of the two, at most what both cost alone
};

/// Whether parts count their length; else each counts one.
[[nodiscard]] bool countsLength(EditCost cost);

struct EditOptions {
  EditUnit unit = EditUnit::segment;
  EditCost cost = EditCost::topology;
  bool mergesPaths = false;    // one part may stand for a path of up to `longestPath` parts
  std::size_t longestPath = 3; // at least 2
  /// Weights of what `attributes` compares; each difference is counted in shares of its range over
  /// both plants.
  double lengthWeight = 1;
  double radiusWeight = 1;
  double orderWeight = 1;
  double directionWeight = 1;

  bool operator==(const EditOptions&) const = default;
};

/// How much of a result must be edited to make it the reference.
struct EditComparison {
  EditOptions options;                        // as asked for
  EditDistance distance;                      // [1] or [L], by the cost
  std::vector<std::vector<NodeId>> result;    // the parts, by vertex: their nodes from the foot up
  std::vector<std::vector<NodeId>> reference; // likewise
  std::size_t matched = 0;                    // parts of the result that stand for something
  std::size_t removed = 0;                    // parts of the result that stand for nothing
  std::size_t inserted = 0;                   // parts of the reference that nothing stands for
};

/// The constrained edit distance of two skeletons as unordered trees of nodes, unbranched segments
/// or axes. Where the parts lie counts for the costs `place` and `shape` only; register first.
///
/// A merged path costs what its union would; the joints within it cost nothing. For segments and
/// nodes, what branches off at a joint is removed and counted already, and without it the two are
/// one segment. Axes are another matter: of one axis and another that it bears, each joint costs as
/// much as the axis that it saves in `topology` and `attributes`, so that merging axes never pays
/// in `topology`.
///
/// @throws Error     if a skeleton cannot be compared, or both have so many parts that their pairs
///                   do not fit into memory
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see editDistance(); `shape` takes a Hausdorff distance for each pair.
/// Source: thesis 5.2 to 5.4; costs after P. Ferraro, C. Godin, Annals of Forest Science 57, 2000.
[[nodiscard]] EditComparison editComparison(const Skeleton& result, const Skeleton& reference,
                                            const EditOptions& options = {},
                                            const Progress& progress = {});

[[nodiscard]] const std::vector<std::string>& editUnitNames(); // in the order of EditUnit
[[nodiscard]] const std::vector<std::string>& editCostNames(); // in the order of EditCost

} // namespace espalier
