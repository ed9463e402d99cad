#pragma once

#include "core/skeleton/skeleton.h"

#include <cstddef>

namespace espalier {

struct DiademOptions {
  double distance = 0;      // [L], farthest that two landmarks of a pair may be apart; > 0
  double lengthShare = 0.1; // of a path, by which its length may differ beyond `distance`; >= 0
};

/// How well tips and branchings agree together with the paths that lead to them.
struct DiademScore {
  double distance = 0;       // [L], as asked for
  std::size_t landmarks = 0; // tips and branchings of the reference
  std::size_t matched = 0;   // of these: a landmark of the result lies near
  std::size_t connected = 0; // of these: the path there is the same
  double score = 1;          // in [0, 1]: 1 where all is found and nothing invented
};

/// A score like DIADEM's: for each tip and branching of the reference there should be one of the
/// result near, reached along the same path.
///
/// Tips are paired with tips and branchings with branchings, one to one (see landmarkPairs()). A
/// pair is connected if the nearest paired landmarks below the two are a pair themselves, and the
/// paths from these are equally long up to `distance` and a share; or if there is none below
/// either. A landmark of the reference weighs as many tips as it carries, a tip one. The score is
/// the weight of the connected ones in that of all and of what is invented: unpaired tips of the
/// result weigh one, unpaired branchings as many unpaired tips as they carry.
///
/// A reference without branchings or tips, a single node, has the score 1 with nothing invented.
/// pre: options.distance > 0
/// Deterministic. Nodes within an edge change nothing. Time O(N log N + pairs within distance).
/// Source: T. A. Gillette, K. M. Brown, G. A. Ascoli, "The DIADEM metric: comparing multiple
/// reconstructions of the same neuron", Neuroinformatics 9, 2011. Differs: pairs are of least total
/// distance instead of nearest first; thresholds are lengths of the plant, not of the microscope.
[[nodiscard]] DiademScore diademScore(const Skeleton& result, const Skeleton& reference,
                                      const DiademOptions& options);

} // namespace espalier
