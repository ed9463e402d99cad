#include "core/pipeline/clean_parts.h"

#include "core/cloud/far_points.h"
#include "core/cloud/repeated_points.h"

namespace espalier {

void leaveOut(PipelineState& state, const std::vector<Eigen::Index>& kept,
              const std::vector<bool>& isOut) {
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (isOut[i]) state.isLeftOut[static_cast<std::size_t>(kept[i])] = true;
}

void leaveOutFarPoints(PipelineState& state) {
  for (const Eigen::Index far : farPoints(*state.cloud, state.isLeftOut))
    state.isLeftOut[static_cast<std::size_t>(far)] = true;
}

StandingPoints standingOf(const PipelineState& state) {
  return standingPoints(*state.cloud, keptPoints(state), state.up);
}

StandingPoints allStandingOf(const PipelineState& state) {
  return standingPoints(
      *state.cloud, repeatedPoints(*state.cloud) | PointSet::of(farPoints(*state.cloud)), state.up);
}

Eigen::Vector3f footOf(const PipelineState& state, const StandingPoints& standing) {
  if (state.chosenRoot) return standing.fromFile(*state.chosenRoot).cast<float>();
  return standing.positions.col(findRoot(standing.positions));
}

} // namespace espalier
