#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// A simulated scan, and where each of its points is from.
struct SimulatedScan {
  RawPoints points; // frame of the plant; intensities in [0, 1]
  /// Per point: whose edge it lies on; none if that is foliage, or if it is stray.
  std::vector<std::optional<NodeId>> nodes;
  std::vector<Eigen::Vector3d> stations; // [L], where the scanner stood; none if it did not
  double angularStep = 0;                // between beams [rad], 0 without stations
};

} // namespace espalier
