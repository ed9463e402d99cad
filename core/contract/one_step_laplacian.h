#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

namespace espalier {

/// Contracts a cloud by one step of the uniform Laplacian: each point moves to the mean of its
/// `neighbors` nearest others. Smooths more than it contracts; the quickest of all.
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]; a single point stays
/// @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N k log N).
/// Source: PlantScan3D's Laplacian contraction.
[[nodiscard]] Eigen::Matrix3Xf contractedByOneLaplacianStep(const Eigen::Matrix3Xf& points,
                                                            int neighbors,
                                                            const Progress& progress = {});

} // namespace espalier
