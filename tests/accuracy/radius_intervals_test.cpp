// How often the true radius lies in the interval that a reconstruction says, of plants that were
// not fitted on, and what the correction of thin wood does to them.
#include "core/base/quantile.h"
#include "core/cloud/spacing_of_places.h"
#include "core/pipeline/cleaned_scan.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/plant_scale.h"
#include "core/radius/wood_radii.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/edge_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

struct Verdict {
  double held = 0;   // share of the true radii that lie in their interval
  double before = 0; // median relative error of radii as fused
  double after = 0;  // and as they are given
};

/// Lengths as they were by default when the correction was fitted.
PipelineOptions coarse(const PointCloud& cloud) {
  const PlantScale scale = scaleOf(cloud, {}, UpAxis::z);
  const double thickness = std::min(enoughThickness, scale.thickness / scale.spacing);
  PipelineOptions options;
  const auto set = [&](const char* name, double spacings) {
    options.set(std::string(name) + "=" + std::to_string(spacings) + " spacings");
  };
  set("contract.radius", 1.5 + 2.4 * thickness);
  set("skeleton.bin_width", 2 + 1.6 * thickness);
  set("join.widest", 10);
  set("prune.length", 7.25 + 1.5 * thickness);
  for (const char* setting : {"skeleton.neighbors=12", "prune.least_odds=0.1"})
    options.set(setting);
  return options;
}

enum class Lengths { byDefault, coarse };

Verdict verdictOn(const Skeleton& truth, const ScannerOptions& scanner, std::uint64_t seed,
                  Lengths lengths) {
  const auto cloud = std::make_shared<const PointCloud>(scan(truth, scanner, seed).points);
  const PipelineOptions options = lengths == Lengths::coarse ? coarse(*cloud) : PipelineOptions();
  const Skeleton plant = *Pipeline().run(cloud, options).skeleton;
  const Eigen::Matrix3Xf points = keptPositions(cleanedScan(cloud, {}).state);
  const double spacing = pointSpacing(points);
  const AssignedPoints assigned(plant, points, cloud->origin());
  const auto fused =
      fusedWood(plant, assigned, measuredWood(plant, assigned, {.spacing = spacing}), spacing);
  const EdgeIndex wood(truth);
  Verdict verdict;
  std::vector<double> before, after;
  for (const NodeId id : plant.ids()) {
    const auto place = wood.nearest(plant[id].position);
    const double radius = truth[place->node].radius;
    if (place->distance > radius + spacing) continue; // invented
    const Node& node = plant[id];
    verdict.held +=
        radius >= node.origin.least * node.radius && radius <= node.origin.most * node.radius;
    before.push_back(std::abs(spacing * fused[indexOf(id)].radius / radius - 1));
    after.push_back(std::abs(node.radius / radius - 1));
  }
  verdict.held /= static_cast<double>(after.size());
  verdict.before = quantile(before, 0.5).value();
  verdict.after = quantile(after, 0.5).value();
  return verdict;
}

/// Means over plants that nothing was fitted on.
Verdict verdictOnAll(Lengths lengths) {
  Verdict mean;
  constexpr int count = 12;
  int plants = 0;
  for (const Architecture architecture :
       {Architecture::broadleaf, Architecture::conifer, Architecture::shrub})
    for (const Eigen::Index points : {2'000, 20'000})
      for (const double foliage : {0.0, 1.0}) {
        const std::uint64_t seed = 4711 + static_cast<std::uint64_t>(plants++);
        const Skeleton truth =
            growPlant({.architecture = architecture, .height = 4, .segments = 100}, seed);
        const Verdict verdict = verdictOn(
            truth, {.points = points, .foliage = foliageOf(architecture, foliage)}, seed, lengths);
        mean.held += verdict.held / count;
        mean.before += verdict.before / count;
        mean.after += verdict.after / count;
      }
  return mean;
}

TEST(RadiusIntervals, HoldTheTruth) {
  const Verdict mean = verdictOnAll(Lengths::byDefault);
  EXPECT_GE(mean.held, 0.85);
  EXPECT_LT(mean.after, mean.before);
  EXPECT_LT(mean.after, 0.13);
}

// The worse a skeleton follows thin wood, the more there is to correct.
TEST(RadiusIntervals, CorrectThinWood) {
  const Verdict mean = verdictOnAll(Lengths::coarse);
  EXPECT_GE(mean.held, 0.85);
  EXPECT_LT(mean.after, 0.8 * mean.before);
}

} // namespace
} // namespace espalier
