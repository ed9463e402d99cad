#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace espalier::test {

/// Points about a known axis. Spacings as core/cloud/point_cloud.h measures them are about
/// `knownSpacing`.
struct KnownPlant {
  Eigen::Matrix3Xf points;
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> axis; // pieces

  [[nodiscard]] double offAxis(const Eigen::Vector3d& place) const; // distance [L]
};

inline constexpr double knownSpacing = 0.01; // of all below [L]

/// A quarter of a circle of radius 1, of wood 0.04 thick.
[[nodiscard]] KnownPlant bentCylinder();
/// The same, seen from one side: half of each section.
[[nodiscard]] KnownPlant halfCylinder();
/// A trunk that forks into two arms 35 degrees off; wood 0.08 thick, points twice as far apart.
[[nodiscard]] KnownPlant knownFork();
/// Straight wood from 0.1 to 0.02 thick, points with noise of a third of a spacing.
[[nodiscard]] KnownPlant noisyCone();

/// How far places are off the axis of a plant, in spacings.
struct OffAxis {
  double mean = 0;
  double within = 0; // share of those within one spacing
};
[[nodiscard]] OffAxis offAxis(const KnownPlant& plant, const Eigen::Matrix3Xf& places);

/// `points` in another order; column i came from column from[i].
struct Shuffled {
  Eigen::Matrix3Xf points;
  std::vector<Eigen::Index> from;
};
[[nodiscard]] Shuffled shuffled(const Eigen::Matrix3Xf& points, std::uint64_t seed);

} // namespace espalier::test
