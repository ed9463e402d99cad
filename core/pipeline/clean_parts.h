#pragma once

#include "core/clean/standing_points.h"
#include "core/pipeline/method_parts.h"

namespace espalier {

/// Leaves out those of the kept points that are marked: one entry per kept point.
void leaveOut(PipelineState& state, const std::vector<Eigen::Index>& kept,
              const std::vector<bool>& isOut);

/// Leaves out the few points that lie far from all others: no step is to be led astray by them.
void leaveOutFarPoints(PipelineState& state);

/// The points that are kept, upright.
[[nodiscard]] StandingPoints standingOf(const PipelineState& state);

/// All points of the scan but repeated ones, upright: also those left out.
[[nodiscard]] StandingPoints allStandingOf(const PipelineState& state);

/// Where the plant stands, upright [L]: the root that was chosen, or else the foot that the kept
/// points show. pre: there are some
[[nodiscard]] Eigen::Vector3f footOf(const PipelineState& state, const StandingPoints& standing);

} // namespace espalier
