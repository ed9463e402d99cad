#include "core/pipeline/quality_of.h"

#include "core/cloud/far_points.h"
#include "core/pipeline/plant_scale.h"

#include <limits>
#include <utility>
#include <vector>

namespace espalier {

ContractionQuality qualityOf(const PointCloud& cloud, const Reconstruction& result,
                             const PipelineOptions& options, const Progress& progress) {
  const PointSet far = PointSet::of(farPoints(cloud, options.leftOut)); // no part of the plant
  const PointSet leftOut = result.apart ? options.leftOut | *result.apart : options.leftOut;
  const std::vector<Eigen::Index> kept = others(leftOut | far, cloud.size());
  if (kept.empty()) return {};
  const Eigen::Matrix3Xf points = cloud.positions()(Eigen::all, kept);
  const Eigen::Matrix3Xf contracted = (*result.contracted)(Eigen::all, kept);
  Eigen::Vector3f root;
  if (options.root) {
    root = (*options.root - cloud.origin()).cast<float>();
  } else {
    const SpatialIndex index(cloud.positions(), progress);
    const PlantExtent extent = plantExtent(cloud, index, leftOut, options.up);
    root = cloud.positions().col(footAmong(kept, cloud, leftOut, options.up, extent.lowest));
  }
  const ContractionQualityOptions how{.spacing = result.scale.spacing, .root = root};
  ContractionQuality quality =
      result.skeleton->isEmpty()
          ? contractionQuality(points, contracted, how, progress)
          : contractionQuality(points, contracted, *result.skeleton, cloud.origin(), how, progress);
  for (std::vector<float>* ofKept : {&quality.thicknesses, &quality.residuals}) {
    std::vector<float> byPoint(static_cast<std::size_t>(cloud.size()),
                               std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < kept.size(); ++i)
      byPoint[static_cast<std::size_t>(kept[i])] = (*ofKept)[i];
    *ofKept = std::move(byPoint);
  }
  return quality;
}

} // namespace espalier
