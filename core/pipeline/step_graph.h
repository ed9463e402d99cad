#pragma once

#include "core/pipeline/pipeline_options.h"

#include <functional>
#include <vector>

namespace espalier {

// The steps as a graph: each takes what one before it made. A whole scan, a region of it and some
// of its points are states of one kind, which the same steps run on, from wherever one is.

/// Is called when a step is computed, on the thread that computes it.
struct StepWatch {
  std::function<void(const Step&)> began;
  std::function<void(const Step&)> ended; // not after a step that failed or was stopped
};

/// One step as it was chosen.
struct ChosenStep {
  const Step* step = nullptr;
  ChosenMethod method;

  /// Measures again what is left, after a method that changes the scale.
  /// pre: the state has what the step takes
  /// @throws Error     if the method does, or makes nodes that are not finite
  /// @throws Cancelled if `progress` asks to stop
  void run(PipelineState& state, const Progress& progress, const StepWatch& watch = {}) const;
  bool operator==(const ChosenStep&) const = default;
};

/// The steps that are still to be run, in order, where `from` is there and `to` is wanted; of those
/// that clean, runCleaning() knows better, as each may change the scale.
/// @param scale  of the whole plant, whatever part of it they run on
/// @throws Error if a method or option is unknown, or a setting is out of range
[[nodiscard]] std::vector<ChosenStep> stepsBetween(StepResult from, StepResult to,
                                                   const PipelineOptions& options,
                                                   const PlantScale& scale);

/// Those that clean, and are on.
[[nodiscard]] std::vector<const Step*> cleaningSteps(const PipelineOptions& options);

/// Cleans: runs steps that do, each by the rules of what is left, from state.extent on.
/// @param done  is called after each
/// @throws Error as stepsBetween() and ChosenStep::run()
void runCleaning(const std::vector<const Step*>& steps, PipelineState& state,
                 const PipelineOptions& options, const Progress& progress,
                 const std::function<void(const ChosenStep&)>& done = {});
/// The same of all that are on.
void runCleaning(PipelineState& state, const PipelineOptions& options, const Progress& progress);

/// Measures the points that are kept: what rules follow from is of them from then on.
/// @throws Error if they are too few for a plant
void measure(PipelineState& state, const Progress& progress);

/// Runs all of them. @throws as ChosenStep::run()
void runSteps(const std::vector<ChosenStep>& steps, PipelineState& state, const Progress& progress);

/// The progress of steps, each a part of that of all by its usual share of the time.
class StepShares {
public:
  /// @param steps all that may run
  StepShares(const std::vector<const Step*>& steps, const Progress& whole);
  [[nodiscard]] Progress next(const Step& step);

private:
  const Progress& whole_;
  double total_ = 0;
  double done_ = 0;
};

} // namespace espalier
