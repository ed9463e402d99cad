#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/graph/find_root.h"
#include "core/pipeline/plant_scale.h"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace espalier {

/// How dense points are kept.
struct NeededPointsOptions {
  /// [spacings] Where the thin wood is at most as thick as this, all points are needed; > 0.
  double thickness = 10;
};

/// Is the thin wood known to be so thick that fewer points may do?
[[nodiscard]] inline bool isThickerThanNeeded(const PlantScale& scale,
                                              const NeededPointsOptions& options) {
  return scale.spacing > 0 && std::isfinite(scale.thickness) &&
         scale.thickness > options.thickness * scale.spacing;
}

/// Which points of a plant its skeleton is better found without: where stems and leaves are much
/// wider than the points are apart, skeletons branch and double inside of them. The plant is
/// reconstructed by default at spacings that double, and that is taken whose skeleton has the
/// largest share of its length probably right, as errorRatings() has it on all points; then those
/// half a step beside it are tried. The widest are tried first, until one is worse.
///
/// @param plant points of the cloud, ascending, no two at one place
/// @param scale of it; its spacing is > 0
/// @return by point of the plant: whether it is left out; none, where no fewer points are better
/// @throws Cancelled if `progress` asks to stop
/// pre: isThickerThanNeeded()
/// Deterministic, on all threads. Time: that of one and a half to three and a half reconstructions
/// by default of all points, of 500 000 at most.
[[nodiscard]] std::vector<bool> notNeeded(const PointCloud& cloud,
                                          const std::vector<Eigen::Index>& plant,
                                          const PlantScale& scale, UpAxis up,
                                          const Progress& progress = {});

} // namespace espalier
