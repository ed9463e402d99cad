#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// Each weight says how much a child loses against its siblings by one measure; at least one is
/// above 0.
struct AxisOptions {
  double sharpestTurn =
      1.0471975511965976; // [rad] no axis turns more where it branches, in (0, pi]
  int reach = 4; // edges before and behind a node over which turn and radius are measured, >= 1
  double carried = 1;      // per halving of the length that it carries, >= 0
  double straightness = 0; // per turn by 60 degrees, >= 0
  double thickness = 0;    // per halving of its radius, >= 0
};

/// Where radii are at hand: what is straight and thick counts, too.
inline constexpr AxisOptions weighedAxes{.straightness = 6, .thickness = 1};

/// Chooses at each branching which child continues the axis: the one that loses least by what it
/// carries, how much it turns and how thick it is, unless it turns off too sharply; all others
/// branch. Where there is one child only, the axis goes on: no expert lets one begin there.
///
/// What a child carries is the length of all that is attached to it, so node spacing does not
/// decide. Turn and radius are measured over several edges, since single ones are short and stray.
/// A child whose radius is not known is as thick as its thickest sibling.
///
/// @param radii by id [L], 0 where none is known; empty: `thickness` has no say
/// Deterministic. Time O(n reach). Source: PlantScan3D counts nodes and looks at single edges, and
/// ends axes at sharp turns of only children, too; the defaults here are the same else.
[[nodiscard]] Skeleton withAssembledAxes(const Skeleton& skeleton, const AxisOptions& options = {},
                                         const std::vector<double>& radii = {});

} // namespace espalier
