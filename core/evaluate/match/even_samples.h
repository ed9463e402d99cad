#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A place on a skeleton that stands for a stretch of it.
struct EvenSample {
  NodeId node;              // the place is on the edge from `node` to its parent
  Eigen::Vector3d position; // [L]
};

/// Samples at even steps along all edges, one after another from each root outward.
///
/// Each sample stands for the same length, total / count, so shares of samples are shares of
/// length, and nodes added within an edge change nothing.
/// @param step [L], > 0; adjusted to divide the total length evenly
/// @param most samples at most: a larger step is taken where more would be needed
/// @return at least one sample if the skeleton has any length, else none. Time O(N + samples).
[[nodiscard]] std::vector<EvenSample> evenSamples(const Skeleton& skeleton, double step,
                                                  std::size_t most = 500'000);

/// pre: there are some
[[nodiscard]] Eigen::Vector3d centroid(const std::vector<EvenSample>& samples); // [L]

} // namespace espalier
