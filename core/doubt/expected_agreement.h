#pragma once

#include "core/decide/error_ratings.h"
#include "core/doubt/doubt.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// What share of the length of a plant is right, as far as the odds say: wood that is reviewed is.
struct ExpectedAgreement {
  double right = 0;  // [L] of the plant
  double wrong = 0;  // likewise
  double missed = 0; // [L] of wood that it lacks

  [[nodiscard]] double share() const { // that is right, in [0, 1]
    const double all = right + wrong + missed;
    return all > 0 ? right / all : 0;
  }
};

/// @param ratings of `skeleton`
/// @param doubts  of it: branches that may be missing count by their odds. O(N + doubts)
[[nodiscard]] ExpectedAgreement expectedAgreement(const Skeleton& skeleton,
                                                  const ErrorRatings& ratings,
                                                  const std::vector<Doubt>& doubts);

/// How many answers, in the order of the doubts, would make the share at least `goal`, in [0, 1].
/// More than there are doubts: all of them do not. O(N + doubts)
[[nodiscard]] std::size_t answersFor(double goal, const Skeleton& skeleton,
                                     const ErrorRatings& ratings, const std::vector<Doubt>& doubts);

} // namespace espalier
