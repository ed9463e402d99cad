#pragma once

#include "core/base/progress.h"
#include "core/simulate/habit.h"
#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <optional>

namespace espalier {

struct GrowthOptions {
  Architecture architecture = Architecture::broadleaf;
  std::optional<Habit> habit; // none: that of the architecture
  double height = 4;          // [L] of the highest node above the base, > 0
  int segments = 800;         // unbranched chains at least, in [1, 20000]
  double nodeSpacing = 0;     // [L], >= 0; 0 = height / 120. Short twigs have shorter edges
  double wander = 1;          // crookedness, in [0, 3]: 0 straight, 1 as the habit has it
  double baseRadius = 0;      // [L], >= 0; 0 = by the habit, 0.006 to 0.013 heights
  double apexRadius = 0;      // [L], >= 0; 0 = by the habit, 0.0006 to 0.0016 heights
  double radiusSpread = 0.08; // of axes about the pipe model (see GrownRadiusOptions), in [0, 1]
};

/// A plant that no one measured, with everything about it known.
///
/// Axes are grown one by one, the longest first, so that a plant of few segments is the same kind
/// of plant without its twigs. An axis strays, turns to the sky or droops, gives way to the wood
/// around it, and ends where it would run into some. It bears branches by the phyllotaxy of its
/// habit, their length and angle following from where on the axis they stand; some rival the axis
/// and push it aside. Radii follow from what each node carries.
///
/// @return one tree, its root at the origin, z up: the longest stem first, each branch attached to
///         the node of its parent's axis that it starts at
/// @throws Error     if an option is out of its range, or there is no room for so many segments
/// @throws Cancelled if `progress` asks to stop
/// Deterministic: the same options and seed give the same plant. Time O(N log N) for N nodes.
/// Source: the order of ideas is that of J. Weber and J. Penn, "Creation and rendering of realistic
/// trees", SIGGRAPH 1995; giving way to other wood after W. Palubicki et al., "Self-organizing tree
/// models for image synthesis", ACM Trans. Graph. 28(3), 2009. Differs: longest axis first.
[[nodiscard]] Skeleton growPlant(const GrowthOptions& options, std::uint64_t seed,
                                 const Progress& progress = {});

} // namespace espalier
