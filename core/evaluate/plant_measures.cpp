#include "core/evaluate/plant_measures.h"

#include "core/base/shown.h"
#include "core/evaluate/comparison_warnings.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/traits/stem_diameter.h"
#include "core/graph/turn_upright.h"
#include "core/surface/generalized_cylinders.h"

#include <algorithm>

namespace espalier {
namespace {

StemDiameter stemOfPlant(const Skeleton& plant, double breastHeight) {
  if (!(breastHeight > 0)) return {{}, Shown::tr("the unit of the lengths is not known")};
  const double foot = plant[stemOf(plant).front()].position.z();
  return stemDiameterAt(plant, foot + breastHeight, StemOf::plant);
}

} // namespace

PlantMeasures plantMeasures(const Skeleton& plant, const PlantMeasureOptions& options,
                            const Progress& progress) {
  requireComparable(plant, ComparedAs::plant);
  const Skeleton upright = standing(plant, options.up);
  PlantMeasures measures;
  measures.traits = traits(upright);
  measures.radiusLimits = radiusLimits(upright);
  measures.wood = woodAmounts(upright, measures.radiusLimits);
  measures.volume = volumeInterval(upright);
  measures.volumeUnknown = volumeOfUnknownError(upright);
  measures.density = options.density;
  const StemDiameter stem = stemOfPlant(upright, options.breastHeight);
  measures.stemDiameter = stem.value;
  measures.stemMissing = stem.missing;
  if (const auto ofTrees = warningOfTrees(measures.traits)) measures.warnings.push_back(*ofTrees);
  if (const auto ofRadii = warningOfNoRadii(upright)) measures.warnings.push_back(*ofRadii);
  if (options.light)
    measures.light =
        lightOn(upright, *options.light, progress.part(0, 1, Shown::tr("Measuring light")));
  progress.update(1);
  return measures;
}

std::optional<LightInterception> lightOn(const Skeleton& plant, const LightOptions& options,
                                         const Progress& progress) {
  const std::vector<NodeId> ids = plant.ids();
  if (std::ranges::none_of(ids, [&](NodeId id) { return plant[id].radius > 0; }))
    return std::nullopt;
  return lightInterception(surfaceByGeneralizedCylinders(plant, {}, progress.part(0, 0.2)), options,
                           progress.part(0.2, 1));
}

Skeleton standing(const Skeleton& plant, UpAxis up) {
  if (up == UpAxis::z) return plant;
  return moved(plant, Eigen::Isometry3d(turnUpright(up)));
}

} // namespace espalier
