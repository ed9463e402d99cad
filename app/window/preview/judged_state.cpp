#include "app/window/preview/judged_state.h"

#include "core/cloud/displacements.h"
#include "core/graph/densities.h"
#include "core/graph/neighborhood_graph.h"
#include "core/graph/orientations.h"
#include "core/pipeline/quality_of.h"

#include <limits>

namespace espalier {
namespace {

constexpr int links = 7;             // per point, as the contractions have
constexpr double densityReach = 3;   // point spacings, as theirs
constexpr double directionReach = 7; // point spacings
constexpr float noValue = std::numeric_limits<float>::quiet_NaN();

const Eigen::Matrix3Xf& scannedIn(const Outcome& outcome, const PointCloud& cloud) {
  return outcome.scanned ? *outcome.scanned : cloud.positions();
}

std::vector<float> radiiOf(const Skeleton& skeleton) {
  std::vector<float> radii;
  for (const NodeId id : skeleton.ids()) {
    if (radii.size() <= indexOf(id)) radii.resize(indexOf(id) + 1, noValue);
    if (skeleton[id].radius > 0) radii[indexOf(id)] = static_cast<float>(skeleton[id].radius);
  }
  return radii;
}

ContractionQuality qualityIn(const Outcome& outcome, const PointCloud& cloud, double spacing,
                             const Progress& progress) {
  if (!outcome.scanned) {
    Reconstruction made;
    made.contracted = outcome.contracted;
    made.skeleton = outcome.skeleton;
    made.scale.spacing = spacing;
    return qualityOf(cloud, made, outcome.options, progress);
  }
  const ContractionQualityOptions options{.spacing = spacing};
  return outcome.skeleton->isEmpty()
             ? contractionQuality(*outcome.scanned, *outcome.contracted, options, progress)
             : contractionQuality(*outcome.scanned, *outcome.contracted, *outcome.skeleton,
                                  cloud.origin(), options, progress);
}

} // namespace

Judgment judged(const Outcome& outcome, const PointCloud& cloud, double spacing,
                const Skeleton* reference, const EvaluationOptions& comparing,
                const Progress& progress) {
  Judgment judgment{.quality = outcome.quality, .scores = std::nullopt};
  if (!judgment.quality && outcome.contracted)
    judgment.quality = std::make_shared<const ContractionQuality>(
        qualityIn(outcome, cloud, spacing, progress.part(0, 0.3)));
  if (reference != nullptr && !outcome.skeleton->isEmpty() && !outcome.within)
    judgment.scores =
        evaluate(*outcome.skeleton, *reference, comparing, progress.part(0.3, 1)).comparison.scores;
  return judgment;
}

std::vector<float> distribution(Distributed kind, const Outcome& outcome, const PointCloud& cloud,
                                double spacing, const Progress& progress) {
  const Eigen::Matrix3Xf& points = scannedIn(outcome, cloud);
  switch (kind) {
  case Distributed::thicknesses:
    return outcome.quality ? outcome.quality->thicknesses : std::vector<float>();
  case Distributed::residuals:
    return outcome.quality ? outcome.quality->residuals : std::vector<float>();
  case Distributed::radii:
    return radiiOf(*outcome.skeleton);
  case Distributed::displacements:
    return outcome.contracted ? displacements(points, *outcome.contracted) : std::vector<float>();
  case Distributed::densities: {
    const NeighborhoodGraph graph(points, links, progress);
    return normalizedDensities(
        radiusDensities(graph, static_cast<float>(densityReach * spacing), progress),
        DensityMeasure::range);
  }
  case Distributed::directions: {
    const NeighborhoodGraph graph(points, links, progress);
    std::vector<float> linearities;
    for (const Orientation& each :
         orientations(points, graph, static_cast<float>(directionReach * spacing), progress))
      linearities.push_back(each.linearity);
    return linearities;
  }
  }
  return {};
}

} // namespace espalier
