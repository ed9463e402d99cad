#pragma once

#include "core/base/progress.h"
#include "core/clean/point_pyramid.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace espalier {

/// What the surroundings of a point show of the organ that it lies on.
///
/// Shapes at five scales, each twice the one before: the second and the third standard deviation of
/// the 16 nearest points, by the first. Then how upright they lie, how thin points lie, what
/// lies behind the point on shortest paths from the root, how far it is to paths that lead on, and
/// the third deviations of the two smallest scales in the mean around it.
using OrganFeatures = std::array<float, 20>;

/// A pyramid with the neighbors and levels that features are looked at in.
[[nodiscard]] PointPyramid organPyramid(const Eigen::Matrix3Xf& points,
                                        const Progress& progress = {});

/// What all points show.
///
/// @param pyramid  of points with z up: its levels are the scales
/// @param root     a point at the foot of the plant
/// @param spacing  of the points [L], > 0
/// @return one per point
/// @throws Cancelled if `progress` asks to stop
/// Deterministic for any number of threads. Time O(N log N).
/// Sources: shapes by principal components, J. Demantke et al., "Dimensionality based scale
/// selection in 3D lidar point clouds", ISPRS Archives XXXVIII-5/W12, 2011; how many shortest paths
/// lead through a point, M. B. Vicari et al., "Leaf and wood classification framework for
/// terrestrial LiDAR point clouds", Methods Ecol. Evol. 10, 2019. Differs: fewer points at larger
/// scales.
[[nodiscard]] std::vector<OrganFeatures> organFeatures(const PointPyramid& pyramid,
                                                       Eigen::Index root, double spacing,
                                                       const Progress& progress = {});

/// Of some class of organs, by point.
using Shares = std::vector<float>;

/// The means of shares around each point, at 3 scales: what shapes alone leave open, neighbors
/// decide.
/// @param shares  of the points of the first level
/// @return by scale
/// Deterministic for any number of threads. Time O(N).
/// Source: Z. Tu, X. Bai, "Auto-context and its application to high-level vision tasks", IEEE
/// Trans. Pattern Anal. Mach. Intell. 32(10), 2010.
[[nodiscard]] std::array<Shares, 3> sharesAround(const PointPyramid& pyramid, const Shares& shares);

} // namespace espalier
