#pragma once

#include "core/decide/error_ratings.h"
#include "core/doubt/doubt.h"
#include "core/pipeline/pipeline.h"

#include <memory>
#include <vector>

namespace espalier {

/// What is in doubt about a plant that was reconstructed, and how probably each edge is wrong.
struct RatedDoubts {
  std::vector<Doubt> doubts; // as findDoubts()
  ErrorRatings ratings;
};

/// The points of a cloud that a reconstruction is of, and its scale was measured on: without those
/// that cleaning set apart. Time O(N) if there are any.
[[nodiscard]] std::shared_ptr<const PointCloud>
pointsOf(const std::shared_ptr<const PointCloud>& cloud, const Reconstruction& result);

/// Nothing is in doubt, and no edge is rated, of a skeleton of less than two nodes.
/// @param cloud  that `result` is from
/// @throws Cancelled if `progress` asks to stop
/// Cost: of findDoubts() and errorRatings(), a fifth of that of the reconstruction.
[[nodiscard]] RatedDoubts doubtsOf(const std::shared_ptr<const PointCloud>& cloud,
                                   const Reconstruction& result, UpAxis up,
                                   const Progress& progress = {});

} // namespace espalier
