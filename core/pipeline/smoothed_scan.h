#pragma once

#include "core/contract/least_squares_surface.h"
#include "core/pipeline/cleaned_scan.h"

#include <memory>
#include <optional>

namespace espalier {

// Smoothing by itself, for those who want its result as a scan.

/// What a method smooths to.
struct SmoothingShape {
  LocalShape shape = LocalShape::sphere;
  LeastSquaresOptions options;
};
/// None if it smooths nothing.
[[nodiscard]] std::optional<SmoothingShape> shapeOf(const ChosenMethod& smoothing);

/// The step that smooths.
[[nodiscard]] const Step& smoothingStep();

struct SmoothedScan {
  /// Points that cleaning keeps where smoothing moves them, then those that are new; each of these
  /// has color, intensity and station of the nearest other.
  PointCloud points;
  Eigen::Index added = 0;            // how many are new
  double moved = 0;                  // of the others, in the mean [L]
  PlantScale scale;                  // of what cleaning leaves
  std::vector<CleaningRecord> steps; // that cleaned
};

/// Cleans a scan, smooths it and fills its holes.
/// @param options  of these steps; others are not looked at
/// @param widest   holes up to this across are filled (core/contract/fill_holes.h); none: no hole
/// is pre: the method of the step Smooth smooths something
/// @throws as cleanedScan()
[[nodiscard]] SmoothedScan smoothedScan(const std::shared_ptr<const PointCloud>& cloud,
                                        const PipelineOptions& options,
                                        const std::optional<Rule>& widest,
                                        const Progress& progress = {});

} // namespace espalier
