#include "tests/support/simulated.h"

#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/surface_sampler.h"

#include <utility>

namespace espalier::test {
namespace {

SimulatedPlant withCloud(Skeleton truth, SimulatedScan scan) {
  PointCloud cloud(scan.points);
  return {std::move(truth), std::move(scan), std::move(cloud)};
}

} // namespace

const SimulatedPlant& simulatedTree() {
  static const SimulatedPlant tree = [] {
    Skeleton truth = growPlant({.height = 4, .segments = 120}, 1);
    SimulatedScan points = scan(truth, {.points = 20'000}, 1);
    return withCloud(std::move(truth), std::move(points));
  }();
  return tree;
}

const SimulatedPlant& simulatedHerb() {
  static const SimulatedPlant herb = [] {
    Skeleton truth =
        growPlant({.architecture = Architecture::herb, .height = 300, .segments = 25}, 1);
    SimulatedScan points = sampleSurface(truth, {.points = 4000}, 1);
    return withCloud(std::move(truth), std::move(points));
  }();
  return herb;
}

ScannerOptions idealScanner(Eigen::Index points) {
  return {.points = points,
          .rangeNoise = 0,
          .misalignment = 0,
          .angularNoise = 0,
          .beamWidth = 0,
          .grazingLoss = 0,
          .strayShare = 0};
}

} // namespace espalier::test
