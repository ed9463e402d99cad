#include "tests/support/leafy_plants.h"

#include "core/base/random.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"

#include <cmath>
#include <utility>

namespace espalier::test {

LabeledCloud labeledScanOf(const Skeleton& plant, const Foliage& foliage, Eigen::Index points) {
  const SimulatedScan scanned = scan(plant, {.points = points, .foliage = foliage}, 5);
  LabeledCloud labeled{PointCloud(scanned.points), {}};
  for (const std::uint32_t from : labeled.cloud.fileOrder())
    labeled.organs.push_back(scanned.organs[from]);
  return labeled;
}

const LabeledCloud& leafyHerb() {
  static const LabeledCloud herb = [] {
    Foliage foliage{
        .blades = {.spacing = 0.08, .length = 0.2, .width = 0.11, .angle = 0.9, .reach = 9}};
    foliage.petiole = 0.6;
    foliage.droop = 0.8;
    return labeledScanOf(
        growPlant({.architecture = Architecture::herb, .height = 0.5, .segments = 1}, 90'001),
        foliage, 12'000);
  }();
  return herb;
}

PointCloud hangingLeaf() {
  Random random(3);
  Eigen::Matrix3Xf points(3, 8000);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double turn = random.uniform(0, 6.28);
    if (i < 5000) // the stem
      points.col(i) =
          Eigen::Vector3d(0.01 * std::cos(turn), 0.01 * std::sin(turn), random.uniform())
              .cast<float>();
    else { // a blade 0.2 wide that hangs from a height of 0.3 to 0.1 below the foot
      const double along = random.uniform();
      points.col(i) = Eigen::Vector3d(0.01 + 0.3 * std::sqrt(along), random.uniform(-0.1, 0.1),
                                      0.3 - 0.4 * along)
                          .cast<float>();
    }
  }
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>());
  return PointCloud(std::move(raw));
}

} // namespace espalier::test
