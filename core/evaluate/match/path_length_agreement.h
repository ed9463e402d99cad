#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <cstdint>

namespace espalier {

struct PathLengthOptions {
  double distance = 0; // [L], farthest that a place may be from the result; > 0
  double step = 0;     // [L], between the places that are drawn from; > 0
  std::size_t pairs = 2000;
  std::uint64_t seed = 1;
};

/// Whether paths along the plant are as long in a result as in its reference.
struct PathLengthAgreement {
  double distance = 0;       // [L], as asked for
  std::size_t pairs = 0;     // of places of the reference that are connected there
  std::size_t found = 0;     // of these: the result is near at both ends
  std::size_t connected = 0; // of these: it is connected between them
  double meanError = 0;      // |path in the result / path in the reference - 1|, of connected pairs
  double medianError = 0;    // likewise
  double withinTenth = 1;    // in [0, 1]: share of all pairs whose path differs by a tenth at most
};

/// Compares the paths along the plant between places of the reference, drawn at random, with those
/// between the nearest places of the result.
///
/// A wrong connection anywhere on a path changes its length, be it covered by wood that is right
/// or not. Places less than `distance` apart along the plant are not drawn: their paths would
/// depend on the position more than on the connection.
///
/// pre: distance > 0, step > 0
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic by the seed. Time O(N log N + pairs (log N + depth)).
[[nodiscard]] PathLengthAgreement pathLengthAgreement(const Skeleton& result,
                                                      const Skeleton& reference,
                                                      const PathLengthOptions& options,
                                                      const Progress& progress = {});

} // namespace espalier
