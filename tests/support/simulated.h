#pragma once

#include "core/cloud/point_cloud.h"
#include "core/simulate/laser_scanner.h"
#include "core/skeleton/skeleton.h"

namespace espalier::test {

/// A plant whose structure is known, and its scan.
struct SimulatedPlant {
  Skeleton truth;
  SimulatedScan scan;
  PointCloud cloud; // of the scan; cloud.fileOrder() leads back to scan.nodes
};

/// A broadleaf tree of 4 m and 120 segments, 20 000 points from four stations with common errors.
/// Made once.
[[nodiscard]] const SimulatedPlant& simulatedTree();

/// A herb of 300 mm and 25 segments, 4000 points evenly all over it, without errors. Made once.
[[nodiscard]] const SimulatedPlant& simulatedHerb();

/// A scanner without errors.
[[nodiscard]] ScannerOptions idealScanner(Eigen::Index points);

} // namespace espalier::test
