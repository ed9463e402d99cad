#include "core/simulate/beam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

// Echoes closer than this share of the extent of the plant blend into one: 10 cm for 4 m.
constexpr double pulseLength = 1.0 / 40;

Vector3d directionOf(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

/// Where the ray enters the first clump of leaves; infinity if none.
double leavesAt(const std::vector<LeafClump>& clumps, const Ray& ray) {
  double first = std::numeric_limits<double>::infinity();
  for (const LeafClump& clump : clumps) {
    const double nearest = (clump.center - ray.origin).dot(ray.direction);
    const double inside = clump.radius * clump.radius -
                          (ray.origin + nearest * ray.direction - clump.center).squaredNorm();
    if (inside > 0 && nearest > 0) first = std::min(first, nearest - std::sqrt(inside));
  }
  return first;
}

std::optional<WoodHit> hitOf(const ScanScene& scene, const Ray& ray) {
  const double leaves = leavesAt(scene.clumps, ray);
  std::optional<WoodHit> wood = scene.wood.firstHit(ray, leaves);
  std::optional<WoodHit> blade = scene.blades.firstHit(ray, wood ? wood->range : leaves);
  return blade ? blade : wood;
}

/// A direction within the beam around `direction`.
Vector3d withinBeam(const Vector3d& direction, double radius, CountedRandom& random) {
  const Vector3d side = direction.unitOrthogonal();
  const double away = radius * std::sqrt(random.uniform());
  const double angle = 2 * pi * random.uniform();
  return (direction + away * (std::cos(angle) * side + std::sin(angle) * direction.cross(side)))
      .normalized();
}

/// What the whole beam meets: two places of its section stand for it.
std::optional<WoodHit> hitOfBeam(const ScanScene& scene, const Ray& ray, double radius,
                                 CountedRandom& random) {
  std::optional<WoodHit> center = hitOf(scene, ray);
  if (radius == 0) return center;
  std::optional<WoodHit> aside =
      hitOf(scene, {ray.origin, withinBeam(ray.direction, radius, random)});
  const double share = random.uniform();
  if (!center && !aside) return std::nullopt;
  if (!center || !aside) { // half an echo is not always enough
    if (share < 0.5) return std::nullopt;
    return center ? center : aside;
  }
  if (aside->range < center->range) std::swap(center, aside);
  if (aside->range - center->range < pulseLength * scene.extent)
    center->range += 0.5 * (aside->range - center->range);
  return center;
}

} // namespace

ScanWindow windowOf(const Vector3d& station, const Eigen::AlignedBox3d& bounds) {
  const Vector3d outside =
      (bounds.min() - station).cwiseMax(station - bounds.max()).cwiseMax(Vector3d::Zero());
  const double nearest = outside.head<2>().norm();
  if (nearest == 0) return {station, -pi, -pi / 2, 2 * pi, pi};
  const Vector3d toMiddle = bounds.center() - station;
  const double middle = std::atan2(toMiddle.y(), toMiddle.x());
  double spread = 0;
  double farthest = 0;
  for (int corner = 0; corner < 4; ++corner) {
    const Vector3d to =
        bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - station;
    const double azimuth = std::remainder(std::atan2(to.y(), to.x()) - middle, 2 * pi);
    spread = std::max(spread, std::abs(azimuth));
    farthest = std::max(farthest, to.head<2>().norm());
  }
  const double low = bounds.min().z() - station.z();
  const double high = bounds.max().z() - station.z();
  const double bottom = std::atan2(low, low < 0 ? nearest : farthest);
  const double top = std::atan2(high, high > 0 ? nearest : farthest);
  return {station, middle - spread, bottom, 2 * spread, top - bottom};
}

std::optional<Echo> echoOf(const ScanScene& scene, const Vector3d& station, double azimuth,
                           double elevation, double step, CountedRandom random) {
  const ScannerOptions& options = scene.options;
  const double jitter = options.angularNoise * step;
  azimuth += jitter * random.normal();
  elevation += jitter * random.normal();
  const Ray ray{station, directionOf(azimuth, elevation)};
  const std::optional<WoodHit> found =
      hitOfBeam(scene, ray, 0.5 * options.beamWidth * step, random);
  if (!found) return std::nullopt;
  const double facing = std::clamp(-found->normal.dot(ray.direction), 0.0, 1.0);
  if (random.uniform() < options.grazingLoss * std::pow(1 - facing, 3)) return std::nullopt;
  const double noise =
      std::hypot(scene.rangeNoise, options.rangeNoiseInSteps * step * found->range);
  const double range = found->range + noise * random.normal();
  // As bright as the surface faces the scanner, falling with the square of the range.
  const double fall = options.distance * scene.extent / (options.distance * scene.extent + range);
  const double intensity = 2.5 * facing * fall * fall * (1 + 0.05 * random.normal());
  return Echo{station + range * ray.direction, static_cast<float>(std::clamp(intensity, 0.0, 1.0)),
              found->node, found->organ};
}

} // namespace espalier
