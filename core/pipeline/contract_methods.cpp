#include "core/pipeline/contract_methods.h"

#include "core/contract/geodesic_centroid.h"
#include "core/pipeline/method_parts.h"

namespace espalier {
namespace {

Method geodesicCentroidMethod() {
  using Options = GeodesicCentroidOptions;
  OptionTable<Options> table;
  table.add({.name = "neighbors",
             .label = "Neighbors",
             .kind = OptionKind::count,
             .rule = fixedAt(7),
             .minimum = 3,
             .maximum = 64,
             .help = "Links per point along which distances are measured."},
            &Options::neighbors);
  table.add({.name = "radius",
             .label = "Radius",
             .kind = OptionKind::length,
             .rule = spacings(7.5),
             .minimum = 1,
             .maximum = 60,
             .help = "Each point moves to the mean of the points within this distance along the "
                     "plant. More than the radius of the thickest wood blurs twigs."},
            &Options::radius);
  return {.name = "geodesic_centroid",
          .label = "Geodesic centroids",
          .help = "Moves each point to the mean of the points near it along the plant.",
          .source = "C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.6",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const std::vector<Eigen::Index> kept = keptPoints(state);
            requirePlant(kept);
            Eigen::Matrix3Xf positions = state.cloud->positions();
            positions(Eigen::all, kept) = contractedToGeodesicCentroids(
                positions(Eigen::all, kept), table.with(values), progress);
            state.contracted = std::make_shared<const Eigen::Matrix3Xf>(std::move(positions));
          }};
}

} // namespace

std::vector<Method> contractMethods() {
  return {geodesicCentroidMethod(), noMethod("Leaves the points where they are.")};
}

} // namespace espalier
