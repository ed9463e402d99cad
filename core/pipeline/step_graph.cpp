#include "core/pipeline/step_graph.h"

#include "core/base/error.h"
#include "core/skeleton/finite_node.h"

#include <cassert>

namespace espalier {
namespace {

/// @throws Error if a step made what no file and no project can keep
void requireFinite(const Skeleton& skeleton, const ChosenStep& choice) {
  for (const NodeId id : skeleton.ids())
    if (!isFinite(skeleton[id]))
      throw Error("step " + choice.step->name + ", method " + choice.method.method->name +
                  ": node " + std::to_string(indexOf(id)) +
                  " gets a position or radius that is not finite: choose another method, and check "
                  "the scan for many points at one place");
}

} // namespace

void ChosenStep::run(PipelineState& state, const Progress& progress, const StepWatch& watch) const {
  assert(state.made >= step->takes);
  if (watch.began) watch.began(*step);
  method.run(state, progress);
  state.made = step->makes;
  requireFinite(*state.skeleton, *this);
  if (watch.ended) watch.ended(*step);
}

std::vector<ChosenStep> stepsBetween(StepResult from, StepResult to, const PipelineOptions& options,
                                     const PlantScale& scale) {
  std::vector<ChosenStep> steps;
  for (const Step& step : pipelineSteps())
    if (step.makes > from && step.makes <= to)
      steps.push_back({&step, chosenFor(step, options, scale)});
  return steps;
}

void runSteps(const std::vector<ChosenStep>& steps, PipelineState& state,
              const Progress& progress) {
  StepShares shares(steps, progress);
  for (const ChosenStep& each : steps)
    each.run(state, shares.next(*each.step));
}

StepShares::StepShares(const std::vector<ChosenStep>& steps, const Progress& whole)
    : whole_(whole) {
  for (const ChosenStep& each : steps)
    total_ += each.step->share;
}

Progress StepShares::next(const Step& step) {
  const double from = done_;
  done_ += step.share / total_;
  return whole_.part(from, done_, step.label);
}

} // namespace espalier
