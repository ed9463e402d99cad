#pragma once

#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <string>
#include <vector>

namespace espalier {

/// Ways in which a skeleton is made worse, each by some level from 0, not at all.
enum class Perturbation {
  position, // standard deviation of each coordinate of each node, in median edges
  reparent, // share of the segments attached to the nearest node they neither carry nor stand on
  prune,    // share of the terminal segments cut off
  shorten,  // share of its length that each terminal segment loses
  spurs,    // spurs of a median edge, sideways, per node
  resample, // nodes this many median edges apart, on the same lines; ends and branchings stay
  shift,    // of the whole, in median edges, in a random direction
  turn      // of the whole about the middle of its box and a random axis [rad]
};

/// What a perturbation is called, and what the numbers of its level mean.
struct PerturbationEntry {
  std::string name;           // "position"
  std::string unit;           // "median edges"
  std::vector<double> levels; // that a study takes unless others are given; rising
  double least;               // level but for 0, which changes nothing
  double most;                // likewise
};

[[nodiscard]] const std::vector<PerturbationEntry>& perturbations(); // in the order of the enum

/// @throws Error that states the range, if the level is neither 0 nor in that of its entry
void requireLevel(Perturbation kind, double level);

/// `skeleton` made worse. Ids stay, but for nodes that go or are added.
///
/// The same seed gives the same plant, and a higher level of `position`, `shift` and `turn` is more
/// of the same: the directions are equal. Shares are rounded to whole nodes or segments.
///
/// @param level 0, or in the range of its entry
/// @throws Error if the skeleton has no nodes, no length, or a position that is no number; if the
///               level is outside its range
/// Time O(N log N), for `reparent` at worst O(N^2).
[[nodiscard]] Skeleton perturbed(const Skeleton& skeleton, Perturbation kind, double level,
                                 std::uint64_t seed);

} // namespace espalier
