#include "core/pipeline/pipeline_start.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/pipeline/method_parts.h"

#include <cmath>
#include <utility>

namespace espalier {

PipelineState firstState(const std::shared_ptr<const PointCloud>& cloud, const PointSet& leftOut) {
  std::vector<bool> isLeftOut(static_cast<std::size_t>(cloud->size()), true);
  for (const Eigen::Index kept : others(leftOut, cloud->size()))
    isLeftOut[static_cast<std::size_t>(kept)] = false;
  return {.cloud = cloud,
          .isLeftOut = std::move(isLeftOut),
          .contracted = {cloud, &cloud->positions()}, // of the cloud: no copy
          .root = 0,
          .radiusSources = {}};
}

Eigen::Index rootPoint(const PipelineState& cleaned, const PipelineOptions& options) {
  const std::vector<Eigen::Index> kept = keptPoints(cleaned);
  if (kept.empty()) return 0;
  const Eigen::Matrix3Xf points = cleaned.cloud->positions()(Eigen::all, kept);
  const Eigen::Index found =
      options.root ? nearestPoint(points, (*options.root - cleaned.cloud->origin()).cast<float>())
                   : findRoot(points, options.up);
  return kept[static_cast<std::size_t>(found)];
}

void requireNearRoot(const PointCloud& cloud, const PipelineOptions& options) {
  if (!options.root) return;
  const Eigen::AlignedBox3d box = cloud.bounds();
  const double away = box.exteriorDistance(*options.root);
  if (away > box.diagonal().norm())
    throw Error("the root lies " + plainDecimal(std::round(away)) +
                " away from the scan: give a place in its coordinates");
}

} // namespace espalier
