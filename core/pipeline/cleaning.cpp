#include "core/pipeline/cleaning.h"

#include "core/cloud/repeated_points.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"

namespace espalier {

std::vector<CleaningMethod> cleaningMethods() {
  std::vector<CleaningMethod> all;
  for (const Step& step : pipelineSteps())
    if (step.makes == StepResult::cleaned)
      for (const Method& method : step.methods)
        if (!isNoMethod(method) && !method.triesPlant) all.push_back({&step, &method});
  return all;
}

Imported<PointSet> leftOutBy(const Method& method, const std::vector<double>& values,
                             const std::shared_ptr<const PointCloud>& cloud,
                             const PipelineOptions& options, const Progress& progress) {
  PipelineState state = firstState(cloud, options);
  const std::vector<bool> before = state.isLeftOut;
  method.run(state, values, progress);
  std::vector<bool> isFound(before.size());
  for (std::size_t i = 0; i < isFound.size(); ++i)
    isFound[i] = state.isLeftOut[i] && !before[i];
  forEachRepeated(
      *cloud, [&](Eigen::Index point) { return !before[static_cast<std::size_t>(point)]; },
      [&](Eigen::Index point, Eigen::Index like) {
        isFound[static_cast<std::size_t>(point)] = isFound[static_cast<std::size_t>(like)];
      });
  std::vector<Eigen::Index> found;
  for (std::size_t i = 0; i < isFound.size(); ++i)
    if (isFound[i]) found.push_back(static_cast<Eigen::Index>(i));
  return {PointSet::of(found) - options.leftOut, std::move(state.notes)};
}

} // namespace espalier
