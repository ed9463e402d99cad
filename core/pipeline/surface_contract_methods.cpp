#include "core/contract/one_step_laplacian.h"
#include "core/pipeline/contract_parts.h"

namespace espalier {
namespace {

struct OneStepOptions {
  int neighbors = 7;
};

Method oneStepLaplacianMethod() {
  OptionTable<OneStepOptions> table;
  Option neighbors = linksOption();
  neighbors.help = "How many of the nearest points each one moves to the mean of.";
  table.add(neighbors, &OneStepOptions::neighbors);
  return contractMethod<OneStepOptions>(
      {.name = "one_step_laplacian",
       .label = "One Laplacian step",
       .help = "Moves each point to the mean of its nearest ones: a slight smoothing.",
       .source = "Laplacian contraction of PlantScan3D"},
      table,
      [](const auto& points, const OneStepOptions& options, const auto&, const Progress& progress) {
        return contractedByOneLaplacianStep(points, options.neighbors, progress);
      });
}

} // namespace

std::vector<Method> surfaceContractMethods() {
  return {oneStepLaplacianMethod()};
}

} // namespace espalier
