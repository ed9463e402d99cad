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
  double thickness = 4;
};

/// Is the thin wood known to be so thick that fewer points may do?
[[nodiscard]] inline bool isThickerThanNeeded(const PlantScale& scale,
                                              const NeededPointsOptions& options) {
  return scale.spacing > 0 && std::isfinite(scale.thickness) &&
         scale.thickness > options.thickness * scale.spacing;
}

/// Which points of a plant its skeleton is better found without: where points are so dense that
/// they show each needle, skeletons have a twig for each, and where stems and leaves are much wider
/// than points are apart, skeletons branch and double inside of them.
///
/// Where the thin wood is up to 10 spacings thick, and points scatter by less than 1.5 spacings,
/// the spacing grows by the root of two as long as the ends in the skeletons of up to five parts of
/// the plant, 40 or more, become fewer by a factor of 1.7 so, and 5000 points are left.
///
/// Where it is thicker, or not known, the plant is reconstructed by default at spacings that
/// double, and that is taken whose skeleton has the largest share of its length probably right, as
/// errorRatings() has it on all points; then those half a step beside it are tried. The widest of a
/// hundredth of the points or more are tried first, until one is worse.
///
/// @param plant points of the cloud, ascending, no two at one place
/// @param scale of it; its spacing is > 0
/// @return by point of the plant: whether it is left out; none, where no fewer points are better
/// @throws Cancelled if `progress` asks to stop
/// pre: isThickerThanNeeded()
/// Deterministic, on all threads. Time: that of one or two reconstructions by default of 100 000
/// points; where the thin wood is so thick, of one and a half to three and a half of all points, of
/// 500 000 at most.
[[nodiscard]] std::vector<bool> notNeeded(const PointCloud& cloud,
                                          const std::vector<Eigen::Index>& plant,
                                          const PlantScale& scale, UpAxis up,
                                          const Progress& progress = {});

} // namespace espalier
