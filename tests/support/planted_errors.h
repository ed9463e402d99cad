#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/finding.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace espalier::test {

/// An error as people make it when they correct a skeleton.
struct PlantedError {
  enum class Kind : std::uint8_t {
    missingTwig,  // a branch of up to 3 axes is deleted
    wrongBearer,  // a branch is attached to wood beside its bearer
    foldedBack,   // a branch is attached too far up its bearer, and folds back
    besidePoints, // a node, or a run of them, is moved off its points
    falseBranch,  // a branch leads through air, and ends there or on other wood
    shortFoot     // the stem begins too high
  };
  Kind kind;
  std::vector<NodeId> nodes;             // where it is, in the skeleton with the error
  std::vector<Eigen::Index> points = {}; // that have no wood now, or other wood; ascending
};

inline constexpr int plantedKinds = 6;
[[nodiscard]] const char* nameOf(PlantedError::Kind kind);

struct PlantedPlant {
  Skeleton skeleton;
  std::vector<PlantedError> errors;
};

/// How many of each kind, in the order of PlantedError::Kind: 60.
inline constexpr std::array<int, plantedKinds> plantedCounts = {12, 12, 12, 12, 11, 1};

/// A skeleton with errors that the scan shows, no two at the same place.
///
/// Where there is no room for all of a kind, there are fewer. A twig is missing where at least 8
/// points are over 3 spacings from all other wood; under 30, of one half of them. Bearers are 6 to
/// 60 spacings off; branches fold back by 138 to 169 degrees; what is moved off its points is so by
/// one to two radii, and by at least 4 spacings, along 2 to 10 times that; false branches are 15 to
/// 50 spacings long, at least half of that over 4 spacings from any point, and one half of them
/// ends on other wood; a foot is short by 3 to 8 radii, and at least 15 spacings.
/// @param spacing of the points [L], > 0
/// Deterministic for a seed.
[[nodiscard]] PlantedPlant
withPlantedErrors(const Skeleton& skeleton, const std::shared_ptr<const PointCloud>& cloud,
                  double spacing, std::uint64_t seed,
                  const std::array<int, plantedKinds>& counts = plantedCounts);

/// Whether a finding is at an error: at a node of it, or about points half of which are of it.
[[nodiscard]] bool isOf(const PlantedError& error, const Finding& finding);

} // namespace espalier::test
