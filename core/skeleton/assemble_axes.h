#pragma once

#include "core/skeleton/skeleton.h"

namespace espalier {

struct AxisOptions {
  double sharpestTurn = 1.0471975511965976; // [rad] an axis never turns more at a node, in (0, pi]
  int reach = 4; // edges before and behind a node over which its turn is measured, >= 1
};

/// Chooses at each branching which child continues the axis: the one that carries most, unless it
/// turns off too sharply; all others branch.
///
/// What a child carries is the length of all that hangs on it, so node spacing does not decide. The
/// turn is measured over several edges, since single ones are short and stray.
/// Time O(n reach). Source: PlantScan3D counts nodes and looks at single edges; else the same.
[[nodiscard]] Skeleton withAssembledAxes(const Skeleton& skeleton, const AxisOptions& options = {});

} // namespace espalier
