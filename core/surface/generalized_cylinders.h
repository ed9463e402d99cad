#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"
#include "core/surface/surface_mesh.h"

namespace espalier {

struct SurfaceOptions {
  int sides = 12;     // corners of a section, >= 3
  double turn = 0.26; // most that two neighboring sections turn [rad], > 0: 15 degrees
};

/// Surface of a plant: a generalized cylinder along each axis.
///
/// Circles are swept along the axes (see sectionsOf) and closed by flat caps: each axis is a
/// watertight piece of its own, which begins within the axis that bears it. A section is a regular
/// polygon of the area of its circle, so that volumes are those of truncated cones. An axis without
/// length has no surface. A node without radius gets that of the nearest node with one on its axis
/// (of two, the mean, weighted by distance), else that of the axis that bears it.
///
/// @throws Error     if no node has a radius
/// @throws Cancelled if `progress` asks to stop
/// Time and memory O(sections * sides).
/// Source: J. Bloomenthal, "Modeling the mighty maple", SIGGRAPH 1985: axes as swept circles whose
/// curves leave each other smoothly. Differs: at a branching the pieces overlap, they are not sewn.
[[nodiscard]] SurfaceMesh surfaceByGeneralizedCylinders(const Skeleton& skeleton,
                                                        const SurfaceOptions& options = {},
                                                        const Progress& progress = {});

} // namespace espalier
