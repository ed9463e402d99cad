#pragma once

#include "core/cloud/organ_marks.h"
#include "core/cloud/point_set.h"
#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace espalier {

/// Names a step: given once, and to no other step. 0 names none, but what was before the first.
enum class StepId : std::uint64_t {};

/// The crown envelope before a step and after it, each as the text that the window keeps of it; an
/// empty one: none was chosen.
struct EnvelopeChange {
  std::string before;
  std::string after;

  bool operator==(const EnvelopeChange&) const = default;
};

/// A step of history: what the undo command holds, the journal keeps and the history shows.
///
/// The content of a step never changes. Where a drag goes on, or a scan is replaced, another step
/// with an id of its own takes the place of the one before.
struct HistoryStep {
  StepId id = {};
  std::string text;      // as the history shows it: "Move node 1842"
  std::string author;    // may be empty
  std::int64_t time = 0; // [ms] since 1970-01-01 UTC
  SkeletonDelta delta;
  /// The points of the scan that it sets aside or brings back. As there are no other states, these
  /// points are their own inverse, and those of two steps are what one of them alone has.
  PointSet points = {};
  /// Whether it replaced the contracted points, by others (ContractedPoints) or by none.
  bool replacesContracted = false;
  std::optional<EnvelopeChange> envelope = {}; // none: the step left it as it was
  OrganMarks organs = {};                      // the change of those that were set by hand

  bool operator==(const HistoryStep&) const = default;
};

/// A plant and the edits around it: those before `position` are done, the others undone.
struct History {
  Skeleton skeleton;     // with the first `position` steps done
  PointSet leftOut = {}; // likewise: the points that are set aside
  std::vector<HistoryStep> steps;
  std::size_t position = 0; // <= steps.size()
  OrganMarks organs = {};   // with the first `position` steps done: those that were set by hand

  bool operator==(const History&) const = default;
};

/// Ids that a file may name: a larger one would take the memory of all below it.
inline constexpr std::size_t mostIds = std::size_t{1} << 25;

/// Hands out ids until `end` of them are: what a journal adds has ids of its own.
/// pre: end <= mostIds
void growIds(Skeleton& skeleton, std::size_t end);

/// Applies `delta` if it can be: its nodes are in `skeleton` as they were before, and what comes
/// out is a forest. Returns whether it did; else nothing has changed. Time O(changes + the paths
/// from them to the root).
[[nodiscard]] bool tryToApply(const SkeletonDelta& delta, Skeleton& skeleton);

/// The crown envelope after the steps that are done; none: no step changed it.
[[nodiscard]] std::optional<std::string> envelopeAfter(const History& history);

/// The skeleton when so many steps were done. O(changes of the steps behind these)
/// pre: position <= history.position, each step fits where it stands
[[nodiscard]] Skeleton skeletonAt(const History& history, std::size_t position);

/// How many steps were done at the end of each day, the last day left out, whose end is what is
/// done now: of each day the last step counts, the first day first.
/// @param dayOf  numbers the day of a time [ms] since 1970-01-01 UTC, as it is where one works
[[nodiscard]] std::vector<std::size_t>
endsOfDays(std::span<const HistoryStep> done,
           const std::function<std::int64_t(std::int64_t)>& dayOf);

/// The plant before the first step, and no steps.
/// pre: each step fits where it stands
[[nodiscard]] History beginningOf(const History& history);

} // namespace espalier
