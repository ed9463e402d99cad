#pragma once

#include <vector>

namespace espalier {

enum class Architecture {
  broadleaf, // decurrent tree: the trunk loses itself in a round crown
  conifer,   // excurrent tree: one trunk to the top, branches in whorls
  shrub,     // several stems from one base
  herb       // one slender stem with long upright side shoots
};

/// How the axes of one order grow. Shares are of the length of the axis unless said otherwise.
struct OrderHabit {
  double wander = 0.3;     // how far the direction strays along the axis [rad]
  double rise = 0.3;       // turning towards the sky (< 0: the ground) along the whole axis [rad]
  double tipRise = 0;      // the same at the tip alone [rad]
  double bare = 0.15;      // share at the base that bears nothing, in [0, 1)
  double internode = 0.04; // between nodes that bear branches, in heights of the plant
  int budsPerNode = 1;     // 1 alternate, 2 opposite, more: whorled
  double divergence = 0;   // azimuth from one node to the next [rad]
  double angle = 0.8;      // of the branches with this axis at its base [rad]
  double tipAngle = 0.6;   // and at its tip [rad]
  double flatness = 0;     // 0: branches all around, 1: in the level plane
  double ratio = 0.5;      // longest branch / this axis
  double acrotony = 0.5;   // branches get longer from base to tip as share^acrotony
  double basitony = 0.5;   // and shorter as (1 - share)^basitony
  double shortShoots = 0;  // probability that a branch stays short, as fruit wood does
  double fork = 0;         // probability that a branch rivals the axis that bears it
};

/// How a kind of plant branches.
struct Habit {
  int stems = 1;                  // from the base
  double stemLean = 0;            // of the outer stems [rad]
  double baseRadius = 0.011;      // in heights
  double apexRadius = 0.0007;     // in heights
  double flare = 0.3;             // see GrownRadiusOptions
  std::vector<OrderHabit> orders; // of order 0, 1, ...; the last holds for all that follow

  [[nodiscard]] const OrderHabit& order(int order) const; // pre: order >= 0, orders not empty
};

[[nodiscard]] Habit habitOf(Architecture architecture);

} // namespace espalier
