#pragma once

#include "core/base/moments.h"
#include "core/base/progress.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// How the plant runs at a point.
struct Orientation {
  Eigen::Vector3f direction = Eigen::Vector3f::Zero(); // unit, of either sign; zero if unknown
  float linearity = 0; // [0, 1]: 0 where the points spread as far across as along, 1 on a line
};

/// That of the points collected; pre: there are some.
[[nodiscard]] Orientation orientationOf(const Moments& moments);

/// The direction in which the points within `radius` of each one along the graph spread most, by
/// principal components: (l1 - l2) / l1 of the greatest two variances is its linearity.
///
/// A ball of fewer than 3 points, or of no radius, is replaced by the point and those linked to it;
/// a point with no links has no direction. Where the ball is smaller than the wood is thick, the
/// points spread evenly over its surface: linearity is low, and the direction means little.
///
/// @param points 3 x N, those of `graph` [L]
/// @param radius [L]; 0: only links
/// @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N k m / 16) for m points in a ball.
/// Source: C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.5.3.
[[nodiscard]] std::vector<Orientation> orientations(const Eigen::Matrix3Xf& points,
                                                    const NeighborhoodGraph& graph, float radius,
                                                    const Progress& progress = {});

} // namespace espalier
