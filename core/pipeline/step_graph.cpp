#include "core/pipeline/step_graph.h"

#include "core/base/shown_message.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/skeleton/finite_node.h"

#include <algorithm>
#include <cassert>

namespace espalier {
namespace {

/// @throws Error if a step made what no file and no project can keep
void requireFinite(const Skeleton& skeleton, const ChosenStep& choice) {
  for (const NodeId id : skeleton.ids())
    if (!isFinite(skeleton[id]))
      throw ShownError(
          {Shown::tr("step %1, method %2: node %3 gets a position or radius that is not finite: "
                     "choose another method, and check the scan for many points at one place"),
           {choice.step->name, choice.method.method->name, std::to_string(indexOf(id))}});
}

/// After a step that left out more than strays.
void measureAgain(PipelineState& state, const std::vector<bool>& before, const Progress& progress) {
  std::vector<Eigen::Index> newly;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (state.isLeftOut[i] && !before[i]) newly.push_back(static_cast<Eigen::Index>(i));
  const PointSet apart = PointSet::of(newly);
  state.apart = std::make_shared<const PointSet>(state.apart ? *state.apart | apart : apart);
  measure(state, progress);
}

} // namespace

void ChosenStep::run(PipelineState& state, const Progress& progress, const StepWatch& watch) const {
  assert(state.made >= step->takes);
  if (watch.began) watch.began(*step);
  const bool cleans = step->makes == StepResult::cleaned;
  const std::vector<bool> before = cleans ? state.isLeftOut : std::vector<bool>();
  method.run(state, progress);
  state.newlyLeftOut = std::ranges::count(state.isLeftOut, true) - std::ranges::count(before, true);
  if (!cleans) state.newlyLeftOut = 0;
  if (state.newlyLeftOut > 0 && method.method->changesScale) measureAgain(state, before, progress);
  state.made = step->makes;
  requireFinite(*state.skeleton, *this);
  if (watch.ended) watch.ended(*step);
}

std::vector<ChosenStep> stepsBetween(StepResult from, StepResult to, const PipelineOptions& options,
                                     const PlantScale& scale) {
  std::vector<ChosenStep> steps;
  for (const Step& step : pipelineSteps())
    if (step.makes > from && step.makes <= to && !isOff(step, options))
      steps.push_back({&step, chosenFor(step, options, scale)});
  return steps;
}

std::vector<const Step*> cleaningSteps(const PipelineOptions& options) {
  std::vector<const Step*> steps;
  for (const Step& step : pipelineSteps())
    if (step.makes == StepResult::cleaned && !isOff(step, options)) steps.push_back(&step);
  return steps;
}

void runCleaning(const std::vector<const Step*>& steps, PipelineState& state,
                 const PipelineOptions& options, const Progress& progress,
                 const std::function<void(const ChosenStep&)>& done) {
  StepShares shares(steps, progress);
  for (const Step* step : steps) {
    const ChosenStep chosen{step, chosenFor(*step, options, state.extent.scale)};
    chosen.run(state, shares.next(*step));
    if (done) done(chosen);
  }
}

void runCleaning(PipelineState& state, const PipelineOptions& options, const Progress& progress) {
  runCleaning(cleaningSteps(options), state, options, progress);
}

void measure(PipelineState& state, const Progress& progress) {
  const std::vector<Eigen::Index> kept = keptPoints(state);
  requirePlant(kept);
  const auto left = someOf(*state.cloud, kept);
  state.extent =
      plantExtent(*left, SpatialIndex(left->positions(), progress.part(1, 1)), {}, state.up);
  if (state.extent.scale.spacing == 0)
    throw ShownError({espalier::Shown::tr(
        "all points that are left after cleaning are at the same place: clean less")});
}

void runSteps(const std::vector<ChosenStep>& steps, PipelineState& state,
              const Progress& progress) {
  std::vector<const Step*> chosen;
  for (const ChosenStep& each : steps)
    chosen.push_back(each.step);
  StepShares shares(chosen, progress);
  for (const ChosenStep& each : steps)
    each.run(state, shares.next(*each.step));
}

StepShares::StepShares(const std::vector<const Step*>& steps, const Progress& whole)
    : whole_(whole) {
  for (const Step* each : steps)
    total_ += each->share;
}

Progress StepShares::next(const Step& step) {
  const double from = done_;
  done_ += step.share / total_;
  return whole_.part(from, done_, step.label);
}

} // namespace espalier
