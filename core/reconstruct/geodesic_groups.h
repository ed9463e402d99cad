#pragma once

#include "core/base/progress.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

inline constexpr std::uint32_t noGroup = Geodesics::none;

/// The points of a plant in bins of their distance to the root along it, and these in their
/// connected parts: the pieces of wood that lie one after the other.
struct GeodesicGroups {
  std::vector<std::uint32_t> ofPoint; // noGroup where the root cannot be reached
  std::vector<float> distances;       // by point, to the root [L]
  std::vector<std::uint32_t> bins;    // by group: which bin it is of, the root's is 0
  std::vector<double> sizes;          // its points
  std::vector<Eigen::Vector3d> centroids;
  std::vector<double> radii;         // mean distance to the centroid [L]
  std::vector<Eigen::Vector3d> axes; // of the points; as long as they are linear, in [0, 1]
  std::vector<std::vector<std::uint32_t>> adjacent; // sorted, each once
  std::uint32_t root = 0;
};

/// Sizes, centroids, radii and axes of groups, from their points.
/// @param points  3 x N [L], those that were grouped
void measure(GeodesicGroups& groups, const Eigen::Matrix3Xf& points);

/// @param graph    of the points
/// @param points   3 x N [L]
/// @param root     column of a point at the foot of the trunk, in [0, N)
/// @param binWidth [L] along the plant, > 0
/// @throws Error     if over half of the points cannot be reached from `root`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N (k + log N)), memory O(N) for k links per point.
[[nodiscard]] GeodesicGroups geodesicGroups(const NeighborhoodGraph& graph,
                                            const Eigen::Matrix3Xf& points, Eigen::Index root,
                                            double binWidth, const Progress& progress = {});

} // namespace espalier
