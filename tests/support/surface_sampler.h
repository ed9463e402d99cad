#pragma once

#include "core/base/progress.h"
#include "core/simulate/laser_scanner.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>

namespace espalier {

/// One of `points` and `spacing` is given, the other is 0.
struct SamplingOptions {
  Eigen::Index points = 0; // wanted, in [0, 10^8]
  double spacing = 0;      // [L], >= 0: a point for each square of this side
  double noise = 0;        // [L], >= 0: standard deviation across the surface
};

/// Points evenly by chance all over a plant: what a scanner would see that looks from everywhere.
///
/// The sides of the frusta of woodOf are sampled by area; what lies inside other wood is left out,
/// so are the rounded ends of apices. Points have no intensity.
/// @throws Error     if a node has no radius, an option is out of its range, or there is no surface
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(P log N) for P points and N nodes.
[[nodiscard]] SimulatedScan sampleSurface(const Skeleton& plant, const SamplingOptions& options,
                                          std::uint64_t seed, const Progress& progress = {});

} // namespace espalier
