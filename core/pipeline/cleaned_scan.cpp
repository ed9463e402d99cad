#include "core/pipeline/cleaned_scan.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/clean_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plants_of_state.h"
#include "core/pipeline/step_graph.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace espalier {
namespace {

const Step& plantStep() {
  return *std::ranges::find_if(pipelineSteps(), [](const Step& step) {
    return std::ranges::any_of(step.methods, [](const Method& method) { return method.cutsPlot; });
  });
}

/// The only method of the step that can.
const Method& cutting() {
  return *std::ranges::find_if(plantStep().methods,
                               [](const Method& method) { return method.cutsPlot; });
}

std::vector<CleaningRecord> runAll(const std::vector<const Step*>& steps, PipelineState& state,
                                   const PipelineOptions& options, const Progress& progress) {
  std::vector<CleaningRecord> records;
  runCleaning(steps, state, options, progress, [&](const ChosenStep& step) {
    records.push_back({step.step, step.method.method, state.newlyLeftOut, state.notes});
    state.notes.clear();
  });
  return records;
}

PipelineState startOf(const std::shared_ptr<const PointCloud>& cloud,
                      const PipelineOptions& options, const Progress& progress) {
  requireKnown(options);
  if (cloud->size() < 2)
    throw ShownError({espalier::Shown::tr("a plant needs at least 2 points: check the scan")});
  requireNearRoot(*cloud, options);
  PipelineState state = firstState(cloud, options);
  state.extent.scale = scaleOf(*cloud, options.leftOut, options.up, progress);
  if (state.extent.scale.spacing == 0)
    throw ShownError(
        {espalier::Shown::tr("all points of the scan are at the same place: check the scan")});
  return state;
}

/// For each point whether it is kept, those at the place of a kept one with it.
std::vector<bool> keptWithRepeated(const PipelineState& state, const PointSet& setAside) {
  std::vector<bool> isKept(state.isLeftOut);
  isKept.flip();
  const auto counts = [&](Eigen::Index point) { return isKept[static_cast<std::size_t>(point)]; };
  forEachRepeated(*state.cloud, counts, [&](Eigen::Index point, Eigen::Index before) {
    if (!setAside.contains(point))
      isKept[static_cast<std::size_t>(point)] = isKept[static_cast<std::size_t>(before)];
  });
  return isKept;
}

std::vector<Eigen::Index> whereSet(const std::vector<bool>& isSet, bool wanted) {
  std::vector<Eigen::Index> points;
  for (std::size_t i = 0; i < isSet.size(); ++i)
    if (isSet[i] == wanted) points.push_back(static_cast<Eigen::Index>(i));
  return points;
}

/// The lowest point of a plant that is as near to its base as its stem may lean.
Eigen::Vector3d lowestAt(const Eigen::Vector3d& base, const StandingPoints& plant, double reach) {
  Eigen::Index best = 0;
  auto lowest = std::numeric_limits<float>::infinity();
  for (Eigen::Index i = 0; i < plant.positions.cols(); ++i) {
    const Eigen::Vector3f place = plant.positions.col(i);
    if ((place.cast<double>() - base).head<2>().norm() > reach || place.z() >= lowest) continue;
    lowest = place.z();
    best = i;
  }
  return plant.toFile(plant.positions.col(best).cast<double>());
}

} // namespace

CleanedScan cleanedScan(const std::shared_ptr<const PointCloud>& cloud,
                        const PipelineOptions& options, const Progress& progress) {
  CleanedScan result{.state = startOf(cloud, options, progress.part(0, 0.1))};
  result.steps =
      runAll(cleaningSteps(withoutTrials(options)), result.state, options, progress.part(0.1, 1));
  requirePlant(keptPoints(result.state));
  result.leftOut = PointSet::of(whereSet(keptWithRepeated(result.state, options.leftOut), false));
  return result;
}

CutPlot cutPlot(const std::shared_ptr<const PointCloud>& cloud,
                const std::vector<Eigen::Vector3d>& bases, const PipelineOptions& options,
                const Progress& progress) {
  const Step& cut = plantStep();
  PipelineState state = startOf(cloud, options, progress.part(0, 0.1));
  CutPlot result;
  std::vector<const Step*> before = cleaningSteps(withoutTrials(options));
  std::vector<const Step*> behind = before;
  std::erase_if(before, [&](const Step* step) { return step >= &cut; });
  std::erase_if(behind, [&](const Step* step) { return step <= &cut; });
  result.steps = runAll(before, state, options, progress.part(0.1, 0.5));
  const PlantsOptions how =
      plantsOptionsOf(resolvedValues(cut, cutting(), options, state.extent.scale));
  const StandingPoints standing = standingOf(state);
  const PlantParts parts = plantsOfState(state, bases, how, progress.part(0.5, 0.8));
  if (parts.sizes.empty())
    throw ShownError({espalier::Shown::tr(
                          "no stem is found from %1 to %2 above the ground: choose other heights "
                          "by plant.slab_from and plant.slab_to, or say where plants stand"),
                      {plainDecimal(how.slabFrom), plainDecimal(how.slabTo)}});
  for (std::size_t i = 0; i < parts.sizes.size(); ++i) {
    PipelineState own = state;
    own.isLeftOut.assign(own.isLeftOut.size(), true);
    std::vector<Eigen::Index> points;
    for (std::size_t k = 0; k < parts.ofPoint.size(); ++k)
      if (parts.ofPoint[k] == i + 1) points.push_back(standing.columns[k]);
    if (points.size() < 2) continue;
    for (const Eigen::Index point : points)
      own.isLeftOut[static_cast<std::size_t>(point)] = false;
    measure(own, progress);
    const auto all = static_cast<double>(parts.sizes.size());
    (void)runAll(behind, own, options,
                 progress.part(0.8 + 0.2 * static_cast<double>(i) / all,
                               0.8 + 0.2 * static_cast<double>(i + 1) / all));
    CutPlant plant{.points = whereSet(keptWithRepeated(own, options.leftOut), true)};
    if (plant.points.empty()) continue;
    plant.root = lowestAt(parts.bases[i], standingPoints(*cloud, plant.points, options.up),
                          how.together / 2);
    result.plants.push_back(std::move(plant));
  }
  if (result.plants.empty())
    throw ShownError(
        {bases.empty()
             ? espalier::Shown::tr("nothing is left of the plants that are found: let fewer steps "
                                   "leave out points")
             : espalier::Shown::tr("no plant stands at the places that are given: give them in the "
                                   "coordinates of the scan, at the feet of stems"),
         {}});
  return result;
}

} // namespace espalier
