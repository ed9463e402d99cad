#pragma once

#include "core/base/rule.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/point_distances.h"

#include <Eigen/Core>

namespace espalier {

/// What doubts follow from, besides the plant.
struct DoubtSources {
  const PointDistances& distances;               // of the points of the scan to the skeleton
  const SpatialIndex& index;                     // of the positions of their cloud
  PlantScale scale;                              // of the plant; its spacing is > 0
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); // length 1
  CheckOptions limits = {};                      // from where on points are missed
};

} // namespace espalier
