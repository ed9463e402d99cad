#include "core/cloud/thin_wood.h"

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/cloud/wood_around.h"

#include <algorithm>

namespace espalier {
namespace {

/// How the wood is looked at.
struct Look {
  Eigen::Index places;
  double farthest; // [spacings], as woodAround() has it
  double thickest; // [spacings] that is told apart then
};

ThinWood thinWoodBy(const Look& look, const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                    const std::vector<Eigen::Index>& places, double spacing) {
  const Eigen::Index count = std::min(std::ssize(places), look.places);
  std::vector<WoodAround> found(static_cast<std::size_t>(count));
  constexpr Eigen::Index grain = 16;
  parallelFor(
      count,
      [&](Eigen::Index i) {
        const auto place = static_cast<std::size_t>(i * std::ssize(places) / count);
        found[static_cast<std::size_t>(i)] = woodAround(
            points, index, places[place], spacing, {.farthest = look.farthest, .confirms = false});
      },
      {}, grain);
  const double thickest = look.thickest * spacing;
  std::vector<double> thicknesses;
  std::vector<double> scatters;
  for (const WoodAround& wood : found) {
    thicknesses.push_back(std::min(wood.thickness.value_or(thickest), thickest));
    if (wood.scatter) scatters.push_back(*wood.scatter);
  }
  return {.thickness = *quantile(std::move(thicknesses), 0.25),
          .scatter = quantile(std::move(scatters), 0.5).value_or(0)};
}

} // namespace

ThinWood thinWood(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                  const std::vector<Eigen::Index>& places, double spacing) {
  constexpr Eigen::Index fewestPlaces = 16;
  constexpr Look near = {.places = 2000, .farthest = 8, .thickest = 4};
  constexpr Look far = {.places = 500, .farthest = 32, .thickest = thickestThinWood};
  if (std::ssize(places) < fewestPlaces) return {.thickness = thickestThinWood * spacing};
  const ThinWood found = thinWoodBy(near, points, index, places, spacing);
  return found.thickness < near.thickest * spacing
             ? found
             : thinWoodBy(far, points, index, places, spacing);
}

} // namespace espalier
