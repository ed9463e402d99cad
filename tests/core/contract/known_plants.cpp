#include "tests/core/contract/known_plants.h"

#include "core/base/random.h"
#include "tests/support/clouds.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

namespace espalier::test {
namespace {

/// Wood along a curve in the plane y = 0.
struct Wood {
  std::function<Eigen::Vector3d(double)> place; // for [0, 1]
  std::function<double(double)> radius;
  double length = 1;
  double turn = 2 * std::numbers::pi; // of each section that is seen, about +y
  double noise = 0;
};

KnownPlant sampled(const Wood& wood) {
  KnownPlant plant;
  constexpr int pieces = 200;
  for (int i = 0; i < pieces; ++i)
    plant.axis.emplace_back(wood.place(i / double(pieces)), wood.place((i + 1) / double(pieces)));
  // The nearest of points spread by chance are half as far as those on a lattice; jittered ones
  // lie between.
  constexpr double lattice = knownSpacing * 1.6;
  Random random(3);
  std::vector<Eigen::Vector3f> points;
  const auto rings = static_cast<int>(wood.length / lattice);
  for (int ring = 0; ring < rings; ++ring) {
    const double middle = (ring + 0.5) / rings;
    const int around =
        std::max(3, static_cast<int>(std::lround(wood.turn * wood.radius(middle) / lattice)));
    for (int i = 0; i < around; ++i) {
      const double t = (ring + random.uniform()) / rings;
      const double angle = wood.turn * ((i + random.uniform()) / around - 0.5);
      const Eigen::Vector3d along =
          (wood.place(std::min(1.0, t + 1e-4)) - wood.place(std::max(0.0, t - 1e-4))).normalized();
      const Eigen::Vector3d side = Eigen::Vector3d::UnitY();
      const Eigen::Vector3d out = std::cos(angle) * side + std::sin(angle) * along.cross(side);
      const double radius = wood.radius(t) + wood.noise * random.normal();
      points.emplace_back((wood.place(t) + radius * out).cast<float>());
    }
  }
  plant.points.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    plant.points.col(static_cast<Eigen::Index>(i)) = points[i];
  return plant;
}

Wood arc() {
  constexpr double quarter = std::numbers::pi / 2;
  return {.place =
              [](double t) {
                return Eigen::Vector3d(1 - std::cos(t * quarter), 0, std::sin(t * quarter));
              },
          .radius = [](double) { return 0.02; },
          .length = quarter};
}

} // namespace

double KnownPlant::offAxis(const Eigen::Vector3d& place) const {
  double least = std::numeric_limits<double>::max();
  for (const auto& [from, to] : axis) {
    const Eigen::Vector3d along = to - from;
    const double t = std::clamp((place - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (place - from - t * along).norm());
  }
  return least;
}

KnownPlant bentCylinder() {
  return sampled(arc());
}

KnownPlant halfCylinder() {
  Wood wood = arc();
  wood.turn = std::numbers::pi;
  return sampled(wood);
}

KnownPlant knownFork() {
  const double angle = 35 * std::numbers::pi / 180;
  const Eigen::Vector3d fork(0, 0, 2);
  const Eigen::Vector3d arm(1.5 * std::sin(angle), 0, 1.5 * std::cos(angle));
  KnownPlant plant{.points = 0.5F * forkCloud(), .axis = {}};
  plant.axis.emplace_back(Eigen::Vector3d::Zero(), 0.5 * fork);
  plant.axis.emplace_back(0.5 * fork, 0.5 * (fork + arm));
  plant.axis.emplace_back(0.5 * fork, 0.5 * (fork + arm.cwiseProduct(Eigen::Vector3d(-1, 1, 1))));
  return plant;
}

KnownPlant noisyCone() {
  return sampled({.place = [](double t) { return Eigen::Vector3d(0, 0, 1.5 * t); },
                  .radius = [](double t) { return 0.05 - 0.04 * t; },
                  .length = 1.5,
                  .noise = knownSpacing / 3});
}

OffAxis offAxis(const KnownPlant& plant, const Eigen::Matrix3Xf& places) {
  OffAxis result;
  const auto count = static_cast<double>(places.cols());
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const double off = plant.offAxis(places.col(i).cast<double>()) / knownSpacing;
    result.mean += off / count;
    if (off <= 1) result.within += 1 / count;
  }
  return result;
}

Shuffled shuffled(const Eigen::Matrix3Xf& points, std::uint64_t seed) {
  Shuffled result{points, std::vector<Eigen::Index>(static_cast<std::size_t>(points.cols()))};
  std::iota(result.from.begin(), result.from.end(), 0);
  Random random(seed);
  for (std::size_t i = result.from.size(); i > 1; --i)
    std::swap(result.from[i - 1], result.from[random.below(i)]);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result.points.col(i) = points.col(result.from[static_cast<std::size_t>(i)]);
  return result;
}

} // namespace espalier::test
