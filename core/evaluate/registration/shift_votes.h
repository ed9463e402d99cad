#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// Positions of the nodes that mark the shape of a plant: roots, branchings and apices.
[[nodiscard]] std::vector<Eigen::Vector3d> landmarks(const Skeleton& skeleton);

/// The shift from `from` to `to` that most pairs of their places agree on.
///
/// Each pair whose difference is within `radius` of `about` votes for its difference; the mean of
/// the votes in the fullest cube of side `width` wins, the one nearest `about` on a tie.
/// @param about  shift to look around [L]
/// @param radius [L], > 0
/// @param width  [L], > 0: how far votes for one shift may scatter
/// @return none if no pair is that near
/// Deterministic. At most a thousand places of `from` vote, evenly chosen. Time O(votes), memory up
/// to 32 MB; a cube is at least a hundredth of 2 x radius wide.
[[nodiscard]] std::optional<Eigen::Vector3d> votedShift(const std::vector<Eigen::Vector3d>& from,
                                                        const std::vector<Eigen::Vector3d>& to,
                                                        const Eigen::Vector3d& about, double radius,
                                                        double width);

} // namespace espalier
