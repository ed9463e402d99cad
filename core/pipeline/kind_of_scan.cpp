#include "core/pipeline/kind_of_scan.h"

#include "core/clean/organs.h"
#include "core/clean/standing_points.h"
#include "core/cloud/far_points.h"
#include "core/cloud/repeated_points.h"

#include <algorithm>

namespace espalier {
namespace {

constexpr std::size_t mostLookedAt = 100'000; // points
constexpr std::size_t fewestLookedAt = 200;

/// Evenly: a cloud lies along a curve that fills space.
std::vector<Eigen::Index> evenlyChosen(const std::vector<Eigen::Index>& points) {
  if (points.size() <= mostLookedAt) return points;
  std::vector<Eigen::Index> some(mostLookedAt);
  for (std::size_t i = 0; i < some.size(); ++i)
    some[i] = points[i * points.size() / some.size()];
  return some;
}

} // namespace

std::optional<KindOfScan> kindOfScan(const std::shared_ptr<const PointCloud>& cloud,
                                     const PipelineOptions& options, double metersInUnit,
                                     const Progress& progress) {
  const PointSet passed = options.leftOut | repeatedPoints(*cloud, options.leftOut) |
                          PointSet::of(farPoints(*cloud, options.leftOut, progress.part(0, 0.1)));
  const std::vector<Eigen::Index> counted = others(passed, cloud->size());
  if (counted.size() < fewestLookedAt) return std::nullopt;
  const StandingPoints standing = standingPoints(*cloud, evenlyChosen(counted), options.up);
  const Eigen::Vector3f sizes =
      standing.positions.rowwise().maxCoeff() - standing.positions.rowwise().minCoeff();
  constexpr double widest = 100; // m
  if (metersInUnit * sizes.head<2>().maxCoeff() > widest) return std::nullopt;
  const double spacing = pointSpacing(standing.positions, progress);
  std::optional<Eigen::Index> root;
  if (options.root)
    root = nearestPoint(standing.positions, standing.fromFile(*options.root).cast<float>());
  const std::vector<Organ> organs =
      organsAmong(standing.positions, root, spacing, progress.part(0.1, 0.8)).ofPoint;
  const KindFeatures features =
      kindFeatures(standing.positions, organs, spacing, progress.part(0.8, 1));
  std::optional<double> height;
  if (metersInUnit > 0) height = metersInUnit * sizes.z();
  KindOfScan result{.likely = likelyKind(features, fittedKindOdds(), height)};
  std::copy_n(features.begin(), result.shares.size(), result.shares.begin());
  return result;
}

const NamedPreset& presetFor(PlantKind kind) {
  return *std::ranges::find(presets(), kind, &NamedPreset::kind);
}

} // namespace espalier
