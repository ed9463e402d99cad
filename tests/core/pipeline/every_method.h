#pragma once

#include "core/pipeline/registry.h"

#include <string>
#include <utility>
#include <vector>

namespace espalier::test {

using StepAndMethod = std::pair<std::string, std::string>;

/// The names of all methods of all steps.
[[nodiscard]] inline std::vector<StepAndMethod> everyMethod() {
  std::vector<StepAndMethod> all;
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      all.emplace_back(step.name, method.name);
  return all;
}

} // namespace espalier::test
