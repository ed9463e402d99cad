#include "core/pipeline/sweep.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace espalier {
namespace {

/// From where to where values are tried.
struct Span {
  double least;
  double most;
  bool byRatio;

  [[nodiscard]] double at(double share) const {
    return byRatio ? least * std::pow(most / least, share) : least + share * (most - least);
  }
};

Span spanOf(const Option& option, const PlantScale& scale,
            const std::optional<std::pair<double, double>>& between) {
  constexpr double around = 4;
  constexpr double longest = 40; // in point spacings
  const auto [least, most] = option.range(scale);
  if (between) {
    const double from = std::clamp(between->first, least, most);
    const double to = std::clamp(between->second, from, most);
    return {from, to, from > 0 && option.kind != OptionKind::angle};
  }
  const double usual = option.rule.value(scale);
  if (option.kind == OptionKind::angle) return {least, most, false};
  if (usual > 0) {
    const double from = std::max(least, usual / around);
    return {from, std::min(most, around * usual), from > 0};
  }
  const double end = option.kind == OptionKind::length ? longest * scale.spacing : around;
  return {least, std::min(most, least + end), false};
}

} // namespace

std::vector<double> sweepValues(const Option& option, const PlantScale& scale, int count,
                                const std::optional<std::pair<double, double>>& between) {
  std::vector<double> values;
  if (option.takesWords()) {
    for (double value = option.minimum; value <= option.maximum; ++value)
      values.push_back(value);
    return values;
  }
  const Span span = spanOf(option, scale, between);
  for (int i = 0; i < count; ++i) {
    const double value = count == 1 && !between
                             ? option.rule.value(scale)
                             : span.at(static_cast<double>(i) / std::max(count - 1, 1));
    values.push_back(
        option.kind == OptionKind::count
            ? std::clamp(std::round(value), std::ceil(span.least), std::floor(span.most))
            : std::clamp(value, span.least, span.most));
  }
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

const Option& optionOfChosen(const PipelineOptions& options, const std::string& step,
                             const std::string& option) {
  const Step& in = stepNamed(step);
  return optionIn(in, chosenMethod(in, options), option);
}

PlantScale scaleAt(const Step& step, Pipeline& pipeline,
                   const std::shared_ptr<const PointCloud>& cloud, const PipelineOptions& options,
                   const Progress& progress) {
  const bool cleans = step.makes == StepResult::cleaned;
  const Reconstruction cleaned =
      pipeline.run(cloud, options, progress, (cleans ? step : cleaningStep()).name);
  return cleans ? cleaned.steps.back().scale : cleaned.scale;
}

void runSweep(Pipeline& pipeline, const std::shared_ptr<const PointCloud>& cloud,
              const PipelineOptions& options, const std::string& step, const std::string& option,
              const std::vector<double>& values, const std::string& last, const Progress& progress,
              const std::function<void(const SweepResult&)>& each) {
  (void)optionOfChosen(options, step, option);
  const PlantScale scale = scaleAt(stepNamed(step), pipeline, cloud, options, progress.part(0, 0));
  PipelineOptions with = options;
  for (const double value : values) {
    with.settings[step][option] = fixedAt(value);
    (void)resolvedValues(stepNamed(step), chosenMethod(stepNamed(step), with), with, scale);
  }
  const auto count = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    SweepResult result{.value = values[i], .reconstruction = {}, .failure = {}};
    with.settings[step][option] = fixedAt(values[i]);
    const auto done = static_cast<double>(i);
    try {
      result.reconstruction =
          pipeline.run(cloud, with, progress.part(done / count, (done + 1) / count), last);
    } catch (const Error& error) { // another value may do
      result.failure = error.what();
    }
    each(result);
  }
}

} // namespace espalier
