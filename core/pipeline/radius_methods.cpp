#include "core/pipeline/radius_methods.h"

#include "core/pipeline/method_parts.h"
#include "core/radius/measured_radii.h"
#include "core/radius/node_count_pipe_model.h"

namespace espalier {
namespace {

Method nodeCountPipeMethod() {
  return {.name = "node_count_pipe",
          .label = "Node-count pipe model",
          .help = "Radii grow with the number of nodes carried, between those measured at the foot "
                  "and at the tips.",
          .source = "law of the structures published with the thesis of C. Preuksakarn, 2012",
          .options = {},
          .run = [](PipelineState& state, const Values&, const Progress& progress) {
            const std::vector<double> measured = meanPointDistances(
                state.skeleton, keptPositions(state), state.cloud->origin(), progress);
            state.skeleton =
                withNodeCountPipeRadii(state.skeleton, pipeEndRadii(state.skeleton, measured));
          }};
}

} // namespace

std::vector<Method> radiusMethods() {
  return {nodeCountPipeMethod()};
}

} // namespace espalier
