#pragma once

#include "core/base/random.h"
#include "core/simulate/habit.h"
#include "core/simulate/occupancy.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

// All lengths of this file are in heights of the plant.

/// A branch that an axis is going to bear.
struct Sprout {
  double place = 0;   // along the axis
  double azimuth = 0; // about the axis [rad]
  double angle = 0;   // with the axis [rad]
  double length = 0;
  bool rivals = false; // as strong as what follows of the axis, which gives way to it
};

/// An axis before it grows.
struct AxisSeed {
  Eigen::Vector3d base = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double length = 1;
  double spacing = 0.01; // of its nodes
  double clearance = 0;  // radius of the parent's wood, inside of which the axis starts
  double baseRadius = 0; // a guess, for keeping clear of others
  double apexRadius = 0;
};

/// The course that an axis took: positions[0] is its base. Frames move along without twisting.
struct Course {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> directions; // unit, one per position
  std::vector<Eigen::Vector3d> sides;      // unit, across the direction, one per position
  double length = 0;

  /// The direction of a branch at positions[i]; `flatness` as in OrderHabit.
  [[nodiscard]] Eigen::Vector3d branchDirection(std::size_t i, const Sprout& sprout,
                                                double flatness) const;
};

/// The branches that an axis of this length will bear, from base to tip.
/// @param density  how much closer they stand than the habit has it, > 0
[[nodiscard]] std::vector<Sprout> sproutsOf(const OrderHabit& habit, double length, double density,
                                            Random& random);

/// Guess of the radius at `place` along an axis.
[[nodiscard]] double guessedRadius(const AxisSeed& seed, double place);

/// Grows an axis through the room that is left; it may end early.
[[nodiscard]] Course grow(const AxisSeed& seed, const OrderHabit& habit, double wander,
                          const std::vector<Sprout>& sprouts, const Occupancy& wood,
                          Random& random);

} // namespace espalier
