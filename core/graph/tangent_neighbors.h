#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhoods.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace espalier {

// Neighbors that surround a point evenly, chosen in its tangent plane: the k nearest of a point
// that a scanner sampled in lines lie all on its own line.
// Deterministic; on all threads. @throws Cancelled if `progress` asks to stop

/// Stands for the gap in a ring of neighbors: the edge of the surface.
inline constexpr std::uint32_t noNeighbor = std::numeric_limits<std::uint32_t>::max();

/// The neighbors of `point` whose Voronoi cells touch its own in its tangent plane, around it in
/// the order of their angles; noNeighbor where the cell has no bound. Two that follow each other
/// make a triangle of the local Delaunay triangulation with it.
///
/// @param candidates  other points, of which the neighbors are taken; nearest first is fastest
/// Time O(c r) for c candidates and r neighbors.
[[nodiscard]] std::vector<std::uint32_t> voronoiRing(const Eigen::Matrix3Xf& points,
                                                     Eigen::Index point,
                                                     const Eigen::Vector3f& normal,
                                                     std::span<const std::uint32_t> candidates);

/// For each point its ring, without gaps. Time O(N k) for k candidates each.
[[nodiscard]] Neighborhoods voronoiNeighbors(const Eigen::Matrix3Xf& points,
                                             const Eigen::Matrix3Xf& normals,
                                             const Neighborhoods& candidates,
                                             const Progress& progress = {});

/// For each point `count` neighbors that leave no gap wider than `widestGap` [rad] around it: of
/// the nearest ones the farthest give way to others of the candidates that lie in the gaps, as far
/// as there are any. In the order of their angles.
///
/// @param candidates  nearest first, more of them than `count`
/// Time O(N c log c) for c candidates each. Source: L. Linsen, H. Prautzsch, "Local versus global
/// triangulations", Eurographics 2001.
[[nodiscard]] Neighborhoods angleCriterionNeighbors(const Eigen::Matrix3Xf& points,
                                                    const Eigen::Matrix3Xf& normals,
                                                    const Neighborhoods& candidates, int count,
                                                    double widestGap = std::numbers::pi / 2,
                                                    const Progress& progress = {});

} // namespace espalier
