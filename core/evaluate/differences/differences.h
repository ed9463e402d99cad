#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// What an edge is, seen against the other skeleton. An edge goes by the node at its upper end.
enum class Difference : std::uint8_t {
  matched,        // near the other
  missed,         // of the reference, with nothing of the result near
  invented,       // of the result, with nothing of the reference near
  wronglyAttached // of the result: attached to something else in the reference
};

/// A stretch of one skeleton in which the two differ.
struct DifferingPart {
  Difference kind = Difference::missed; // never matched
  /// Connected, parents before their children; of the reference if missed, else of the result. If
  /// wrongly attached: what leads there though nothing of the reference does, then what is
  /// attached, up to its first branching.
  std::vector<NodeId> nodes;
  double length = 0; // [L], of these edges; if wrongly attached, of all that is attached there
  Eigen::Vector3d at = Eigen::Vector3d::Zero(); // where it begins: of the first node, or `attached`

  // Where the reference attaches the part; not for what is invented.
  NodeId attached{};          // if wrongly attached: the first node of it, of the result
  std::optional<NodeId> host; // of the result; none: on nothing that the result has
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // of that, in the reference [L]
  EdgeType edge = EdgeType::branching;             // by which it is attached there

  bool operator==(const DifferingPart&) const = default;
};

/// Where two skeletons differ.
struct Differences {
  double tolerance = 0;                // [L], what is called near
  std::vector<Difference> ofResult;    // by id
  std::vector<Difference> ofReference; // by id; matched or missed
  std::vector<DifferingPart> parts;    // longest first
  /// By id of the result: the edges of the reference that the node stands on.
  std::vector<std::vector<NodeId>> standsOn;

  // Lengths [L]; what is matched, once of each.
  double matchedInResult = 0;
  double matchedInReference = 0;
  double missed = 0;
  double invented = 0;
};

/// Finds which stretches of two skeletons are matched, missed, invented and wrongly attached.
///
/// An edge is near if half of its length lies within `tolerance` of the other skeleton. Stretches
/// shorter than the tolerance that leave what is near are taken for near, and what is near for
/// less than three tolerances between two stretches that are not, as where two twigs cross, is not.
///
/// From the root up, each node of the result keeps those places of the reference within the
/// tolerance that lie on the path up from the places of its parent. A node that keeps none although
/// some are near is wrongly attached: its own place and that of its parent belong to branches that
/// meet more than four tolerances, and what the wood there is thick, below the parent. So is a tree
/// on its own where the reference goes on down along something that the result has, and what is
/// attached by an edge that is not near that much farther down than where the reference attaches
/// it.
///
/// @param result    laid on the reference before, or the other way round: nothing is registered
/// @param tolerance [L], > 0
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + length / tolerance) log N).
[[nodiscard]] Differences differences(const Skeleton& result, const Skeleton& reference,
                                      double tolerance, const Progress& progress = {});

/// Whether two parts, before and after some edit, are one to a person: of one kind, and beginning
/// at most `tolerance` [L] apart.
[[nodiscard]] bool isSame(const DifferingPart& a, const DifferingPart& b, double tolerance);

/// "missed", "invented", "wrongly_attached"
[[nodiscard]] std::string nameOf(Difference difference);

} // namespace espalier
