#pragma once

#include "core/base/progress.h"
#include "core/radius/fused_radii.h"
#include "core/radius/measured_radius.h"
#include "core/radius/radius_evidence.h"

#include <vector>

namespace espalier {

/// Radii of cylinders where points show them, of distances elsewhere, by id.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see cylindersAbout(), withThinRadii().
struct WoodMeasurements {
  std::vector<MeasuredRadius> radii;
  double pointError = 0; // [L], across thick wood; 0: not known
};
[[nodiscard]] WoodMeasurements measuredWood(const Skeleton& skeleton, const AssignedPoints& points,
                                            const CylinderOptions& options,
                                            const Progress& progress = {});

/// These radii, fused with a model, and what is known of each, by id.
///
/// The model is fitted to the measurements, or, where they are too few, is the mean distance of the
/// points. All radii are 0 if none is known.
/// Deterministic. Time O(N + n).
[[nodiscard]] std::vector<RadiusEvidence> fusedWood(const Skeleton& skeleton,
                                                    const AssignedPoints& points,
                                                    const WoodMeasurements& measured,
                                                    double spacing, FusionOptions options = {});

} // namespace espalier
