#include "app/window/preview/density_flow.h"

#include "core/base/error.h"
#include "core/pipeline/used_densities.h"
#include "ui/document/plant_document.h"
#include "ui/panels/pipeline_panel.h"

#include <optional>
#include <vector>

namespace espalier {
namespace {

/// Whether the chosen contraction follows densities; not where a value is out of range, which its
/// form says.
bool followsDensities(const PipelineOptions& options, const PlantScale& scale) {
  try {
    return chosenFor(contractionStep(), options, scale).probe().density.has_value();
  } catch (const Error&) {
    return false;
  }
}

} // namespace

DensityFlow::DensityFlow(PlantDocument& document, JobQueue& queue, PipelinePanel& pipeline)
    : document_(document), pipeline_(pipeline), job_(queue, JobPriority::asked) {
  connect(&pipeline_, &PipelinePanel::changed, this, [this](const Step& step) {
    if (step.makes <= StepResult::contracted) refresh();
  });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged})
    connect(&document_, signal, this, &DensityFlow::refresh);
}

void DensityFlow::refresh() {
  const Scan* scan = document_.scan();
  PipelineOptions options = pipeline_.options();
  options.leftOut = document_.leftOut();
  const Step& step = contractionStep();
  const PlantScale scale = document_.scale();
  if (scan == nullptr || !followsDensities(options, scale)) {
    job_.cancel();
    return pipeline_.setDensities(step.name, {});
  }
  job_.start(
      [cloud = scan->cloud(), options, scale](const Progress& progress) {
        return densitiesUsed(cloud, options, scale, progress);
      },
      [this, name = step.name](const std::optional<std::vector<float>>& densities) {
        pipeline_.setDensities(name, densities.value_or(std::vector<float>()));
      });
}

} // namespace espalier
