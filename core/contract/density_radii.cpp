#include "core/contract/density_radii.h"

#include "core/graph/densities.h"

#include <cmath>

namespace espalier {

std::vector<float> densityRadii(const NeighborhoodGraph& graph, const DensityRadiusOptions& options,
                                const Progress& progress) {
  std::vector<float> radii = normalizedDensities(
      radiusDensities(graph, static_cast<float>(options.densityRadius), progress));
  for (float& value : radii)
    value =
        static_cast<float>(options.least + (options.most - options.least) *
                                               std::pow(static_cast<double>(value), options.curve));
  return radii;
}

} // namespace espalier
