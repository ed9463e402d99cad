#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/authors_comparison.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// Segments that stand for each other: one, and on at most one side a path of several.
struct PathMatch {
  std::vector<std::size_t> result;    // from the root side to the tip side
  std::vector<std::size_t> reference; // likewise
  double cost = 0;                    // Hausdorff distance of what they make up [L]
};

/// The authors' matches, some of them one to many.
struct PathMatches {
  std::vector<PathMatch> matches; // in the order of the one-to-one matches
  std::size_t extended = 0;       // how many are one to many
  double cost = 0;                // of pairs and of segments left alone [L]
  double geometric = 0;           // in [0, 1]: share of the length of both that is matched
  double lengthPrecision = 0;     // in [0, 1]: share of the result's length
  double lengthRecall = 0;        // in [0, 1]: share of the reference's length
};

/// Lets a match take in the unmatched segments that run through it, up or down, on one side, where
/// that brings the two nearer: a spur that cuts a branch in two then costs the spur alone.
///
/// The match that gains most goes first; what it takes in no other may. The matches and their
/// distances are those of `comparison`, nodes against nodes.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(matches * paths), of which only those are tried whose nodes are nearer
/// than the match they would better.
/// Source: the one-to-many extension of the authors' program, which leaves it open in what order.
[[nodiscard]] PathMatches pathMatches(const AuthorsComparison& comparison,
                                      const Progress& progress = {});

} // namespace espalier
