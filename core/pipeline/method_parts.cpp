#include "core/pipeline/method_parts.h"

#include "core/base/error.h"

#include <utility>

namespace espalier {

Method noMethod(std::string help) {
  return {.name = "none",
          .label = "None",
          .help = std::move(help),
          .source = {},
          .options = {},
          .run = [](PipelineState&, const Values&, const Progress&) {}};
}

std::vector<Eigen::Index> keptPoints(const PipelineState& state) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < state.cloud->size(); ++i)
    if (!state.isLeftOut[static_cast<std::size_t>(i)]) kept.push_back(i);
  return kept;
}

Eigen::Matrix3Xf keptPositions(const PipelineState& state) {
  return state.cloud->positions()(Eigen::all, keptPoints(state));
}

void requirePlant(const std::vector<Eigen::Index>& kept) {
  if (kept.size() < 2)
    throw Error("fewer than 2 points are left after cleaning: clean less, choose method none, or "
                "bring points back");
}

} // namespace espalier
