#include "core/contract/density_radii.h"

#include <cmath>

namespace espalier {

double radiusOfDensity(float density, const DensityRadiusOptions& options) {
  return options.least +
         (options.most - options.least) * std::pow(static_cast<double>(density), options.curve);
}

std::vector<float> densityRadii(const NeighborhoodGraph& graph, const DensityRadiusOptions& options,
                                const Progress& progress) {
  const std::vector<float> densities =
      radiusDensities(graph, static_cast<float>(options.densityRadius), progress);
  std::vector<float> radii = options.levels ? normalizedDensities(densities, *options.levels)
                                            : normalizedDensities(densities, options.measure);
  for (float& value : radii)
    value = static_cast<float>(radiusOfDensity(value, options));
  return radii;
}

} // namespace espalier
