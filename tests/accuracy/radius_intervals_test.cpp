// How often the true radius lies in the interval that a reconstruction says, of plants that were
// not fitted on, and what the correction of thin wood does to them.
#include "core/base/quantile.h"
#include "core/cloud/spacing_of_places.h"
#include "core/pipeline/cleaned_scan.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline.h"
#include "core/radius/wood_radii.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/edge_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace espalier {
namespace {

struct Verdict {
  double held = 0;   // share of the true radii that lie in their interval
  double before = 0; // median relative error of radii as fused
  double after = 0;  // and as they are given
};

Verdict verdictOn(const Skeleton& truth, const ScannerOptions& scanner, std::uint64_t seed) {
  const auto cloud = std::make_shared<const PointCloud>(scan(truth, scanner, seed).points);
  const Skeleton plant = *Pipeline().run(cloud).skeleton;
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

TEST(RadiusIntervals, HoldTheTruthAndCorrectThinWood) {
  Verdict sum;
  int plants = 0;
  for (const Architecture architecture :
       {Architecture::broadleaf, Architecture::conifer, Architecture::shrub})
    for (const Eigen::Index points : {2'000, 20'000})
      for (const double foliage : {0.0, 1.0}) {
        const std::uint64_t seed = 4711 + static_cast<std::uint64_t>(plants);
        const Skeleton truth =
            growPlant({.architecture = architecture, .height = 4, .segments = 100}, seed);
        const Verdict verdict =
            verdictOn(truth, {.points = points, .foliage = foliageOf(architecture, foliage)}, seed);
        sum.held += verdict.held;
        ++plants;
        if (points > 2'000) continue; // most wood is thick enough to be measured
        sum.before += verdict.before;
        sum.after += verdict.after;
      }
  EXPECT_GE(sum.held / plants, 0.85);
  EXPECT_LT(sum.after, 0.85 * sum.before);
}

} // namespace
} // namespace espalier
