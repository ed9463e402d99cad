#include "core/radius/wood_radii.h"

#include "core/radius/length_pipe_model.h"
#include "core/skeleton/length_along.h"

#include <algorithm>

namespace espalier {
namespace {

struct WoodModel {
  std::vector<double> radii; // by id [L]
  double spread = 0;         // of the logarithm of radii about it
  double exponent = 0;       // 0: it is no pipe model
};

/// Fitted to the measurements, or, where they are too few, the mean distances of the points.
WoodModel modelOf(const Skeleton& skeleton, const AssignedPoints& points,
                  const std::vector<MeasuredRadius>& measured, double spacing) {
  constexpr double least = 0.08;
  constexpr double most = 0.5;
  if (const auto pipe = fittedLengthPipe(skeleton, measured))
    return {.radii = radiiOf(skeleton, *pipe),
            .spread = std::clamp(pipe->spread, least, most),
            .exponent = pipe->exponent};
  WoodModel model{
      .radii = interpolatedRadii(skeleton, assignedRadii(skeleton, points, AssignedMeasure::mean)),
      .spread = most};
  for (double& radius : model.radii)
    if (!(radius > 0)) radius = spacing / 2; // no node has points
  return model;
}

double meanDistance(const AssignedPoints& points, NodeId id) {
  double sum = 0;
  for (const std::uint32_t column : points.of(id))
    sum += points.distance(column);
  return points.of(id).empty() ? 0 : sum / static_cast<double>(points.of(id).size());
}

} // namespace

WoodMeasurements measuredWood(const Skeleton& skeleton, const AssignedPoints& points,
                              const CylinderOptions& options, const Progress& progress) {
  const auto fitted = cylindersAbout(skeleton, points, options, progress);
  const double error = pointError(fitted);
  return {.radii =
              withThinRadii(skeleton, points,
                            cylinderRadii(withoutScattered(fitted, error), options.spacing), error),
          .pointError = error};
}

std::vector<RadiusEvidence> fusedWood(const Skeleton& skeleton, const AssignedPoints& points,
                                      const WoodMeasurements& measured, double spacing,
                                      FusionOptions options) {
  const WoodModel model = modelOf(skeleton, points, measured.radii, spacing);
  options.modelSpread = model.spread;
  const FusedRadii fused = fusedRadii(skeleton, measured.radii, model.radii, options);
  const std::vector<double> carried = carriedLengths(skeleton);
  std::vector<RadiusEvidence> evidence(skeleton.idEnd());
  for (const NodeId id : skeleton.ids()) {
    const std::size_t i = indexOf(id);
    evidence[i] = {.radius = fused.radii[i] / spacing,
                   .measured = measured.radii[i].radius / spacing,
                   .model = model.radii[i] / spacing,
                   .share = fused.shares[i],
                   .deviation = fused.deviations[i],
                   .modelSpread = model.spread,
                   .exponent = model.exponent,
                   .pointError = measured.pointError / spacing,
                   .meanDistance = meanDistance(points, id) / spacing,
                   .points = static_cast<double>(points.of(id).size()),
                   .carried = carried[i] / spacing};
  }
  return evidence;
}

} // namespace espalier
