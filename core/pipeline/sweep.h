#pragma once

#include "core/pipeline/pipeline.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {

// One option over several values, to see which is best; or the methods of a step, which are swept
// as an option of it that takes their names.

/// The option "method" of a step, whose words are its methods.
[[nodiscard]] const Option& methodOption(const Step& step);

/// `count` values to try of an option, ascending, in the units it is set in ([L], degrees, or
/// none).
///
/// Around its default, from a quarter of it to 4 times it, by equal ratios, but for the default
/// rounded to the three digits that people read; over its range, evenly,
/// if the default is 0 or the option is an angle, where lengths end at 40 point spacings and ratios
/// at 4. Within the range of the option; whole numbers for counts, of which there may be fewer. All
/// words of an option that takes words. pre: count >= 1
/// @param between the least and the greatest value, in place of those that follow from the default
[[nodiscard]] std::vector<double>
sweepValues(const Option& option, const PlantScale& scale, int count,
            const std::optional<std::pair<double, double>>& between = {});

/// The scale that the values of a step follow from, in a run with these options: cleaning, which
/// may change it, is run for that. @throws as Pipeline::run()
[[nodiscard]] PlantScale scaleAt(const Step& step, Pipeline& pipeline,
                                 const std::shared_ptr<const PointCloud>& cloud,
                                 const PipelineOptions& options, const Progress& progress = {});

/// What one value gave.
struct SweepResult {
  double value = 0;
  Reconstruction reconstruction; // empty if it failed
  std::string failure;           // why; empty if it did not
};

/// The options with a value of an option of the method that is chosen for a step. With another
/// method, the step has the defaults of that.
[[nodiscard]] PipelineOptions withValue(const PipelineOptions& options, const Step& step,
                                        const Option& option, double value);

/// Runs the steps up to `last` (empty: all) for each value of an option of the method that is
/// chosen for `step`, or for methods of it, and reports each result as it comes, as well as each
/// value that the steps fail with.
///
/// What lies before the step is computed once; a Pipeline that has run before has it at hand.
/// @throws Error     if the step or option is unknown, or a value out of range, before any run
/// @throws Cancelled if `progress` asks to stop
void runSweep(Pipeline& pipeline, const std::shared_ptr<const PointCloud>& cloud,
              const PipelineOptions& options, const std::string& step, const std::string& option,
              const std::vector<double>& values, const std::string& last, const Progress& progress,
              const std::function<void(const SweepResult&)>& each);

/// The option of the method that is chosen for a step; "method" is methodOption().
/// @throws Error that lists those it has
[[nodiscard]] const Option& optionOfChosen(const PipelineOptions& options, const std::string& step,
                                           const std::string& option);

} // namespace espalier
