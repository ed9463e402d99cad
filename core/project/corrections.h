#pragma once

#include "core/project/history.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace espalier {

/// What was corrected by hand: nodes by what became of them, once per edit that did it. A node
/// that is moved and attached elsewhere by one edit counts as both.
struct Corrections {
  std::size_t edits = 0; // that corrected anything: those of marks and features do not
  std::size_t added = 0;
  std::size_t removed = 0;
  std::size_t moved = 0;
  std::size_t reparented = 0; // attached elsewhere, or made a root; not where only a node of its
                              // edge came or went
  std::size_t retyped = 0;    // `<` to `+` or back, on the same parent
  std::size_t radii = 0;      // set

  bool operator==(const Corrections&) const = default;
};

/// What the edits of a plant amount to.
struct HandWork {
  Corrections corrections;
  std::int64_t time = 0; // [ms] at work: the sum of the times from each step to the next

  bool operator==(const HandWork&) const = default;
};

/// A longer pause is none of work, and counts as nothing [ms].
inline constexpr std::int64_t longestPause = std::int64_t{5} * 60 * 1000;

/// Whether a step made the whole plant anew, as a reconstruction does: it left no earlier node, and
/// is no stroke by which one begins to draw. O(changes)
/// @param size  nodes of the plant after it
[[nodiscard]] bool madePlantAnew(const HistoryStep& step, std::size_t size);

/// The work by hand that led to the present skeleton: the steps that are done, from the last one on
/// that made the whole plant anew (madePlantAnew), which itself is no correction, nor is a step
/// that moved, turned or scaled the plant as a whole. A clock that was set back between two steps
/// adds nothing. O(all changes).
[[nodiscard]] HandWork handWork(std::span<const HistoryStep> done, const Skeleton& skeleton);

/// What edits by hand have decided of the nodes of the present skeleton, by id.
struct MadeByHand {
  /// Drawn as one branch, by a step that removed nothing; no node that such a branch, or another
  /// edit, has put into an edge.
  std::vector<bool> isDrawn;
  std::vector<bool> isAttached; // elsewhere than before, alone of all by one step
};

/// Of the steps that are done, from the last one on that made the whole plant anew.
/// @param stepAt gives the steps 0 to `count` - 1
/// O(all changes)
[[nodiscard]] MadeByHand madeByHand(const std::function<const HistoryStep&(std::size_t)>& stepAt,
                                    std::size_t count, const Skeleton& skeleton);

/// Where a plant came from, before it was corrected by hand.
struct PlantBeginning {
  Skeleton skeleton;
  bool isReconstructed = false; // by a step that made the whole plant anew; else it was opened
};

/// What the work by hand began with: see handWork(). Where the plant was moved as a whole since,
/// this is, too. Empty: the plant was drawn from nothing.
/// O(all changes)
[[nodiscard]] PlantBeginning beginningOfHandWork(const History& history);

} // namespace espalier
