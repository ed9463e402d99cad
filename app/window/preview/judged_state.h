#pragma once

#include "app/window/preview/preview_flow.h"
#include "core/evaluate/evaluation.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// What is known of a state of the plant, in numbers.
struct Judgment {
  std::shared_ptr<const ContractionQuality> quality; // null: it has no contracted points
  std::optional<ScoreValues> scores;                 // none: there is no reference, or no skeleton
};

/// What the numbers of points are that a histogram shows.
enum class Distributed : std::uint8_t {
  thicknesses, // near each point: the residual thickness is their median
  residuals,   // of each point alone
  displacements,
  densities,
  directions,
  radii
};

/// Judges a state of a scan.
/// @param reference null: none
/// @param comparing with the reference
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Judgment judged(const Outcome& outcome, const PointCloud& cloud, double spacing,
                              const Skeleton* reference, const EvaluationOptions& comparing,
                              const Progress& progress);

/// One number per point of a state, or, of radii, per node by its id; not a number where there is
/// none. Empty if the state has none of the kind.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<float> distribution(Distributed kind, const Outcome& outcome,
                                              const PointCloud& cloud, double spacing,
                                              const Progress& progress);

} // namespace espalier
