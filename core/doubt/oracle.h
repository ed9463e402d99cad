#pragma once

#include "core/base/progress.h"
#include "core/doubt/doubt.h"
#include "core/doubt/reference_places.h"

#include <cstddef>

namespace espalier {

/// How a plant agrees with a reference, by length.
struct Agreement {
  double right = 0;  // [L] of the plant, where the reference has wood, and attached as there
  double wrong = 0;  // [L] of the plant, that is not
  double missed = 0; // [L] of the reference

  [[nodiscard]] double share() const { // that is right, in [0, 1]
    const double all = right + wrong + missed;
    return all > 0 ? right / all : 0;
  }
};

/// @param reference  where the plant is: nothing is registered
/// @param tolerance  [L] how far apart is near, > 0
/// Errors and cost as differences().
[[nodiscard]] Agreement agreementWith(const Skeleton& reference, const Skeleton& plant,
                                      double tolerance, const Progress& progress = {});

/// An expert who has a reference, and answers by what it is like at a place, whatever that does to
/// the scores.
class Oracle {
public:
  /// @param reference  where the plant is; it must outlive this
  /// @param tolerance  [L] how far apart is near, > 0
  Oracle(const Skeleton& reference, double tolerance);

  /// Which alternative is right. Wood is there if over half of its length is near the reference,
  /// along a path that is half as long at least and that no other wood of the plant is nearer to.
  /// It grows from the place that the reference leads down to; the present is kept where that is as
  /// right. O(n log N)
  [[nodiscard]] std::size_t answer(const Skeleton& plant, const Doubt& doubt) const;

private:
  [[nodiscard]] bool isWood(const EdgeIndex& others,
                            const std::vector<Eigen::Vector3d>& places) const;
  [[nodiscard]] std::size_t attachment(const Skeleton& plant, const Doubt& doubt) const;

  ReferencePlaces known_;
  double tolerance_;
};

} // namespace espalier
