#include "core/pipeline/region_skeleton.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/graph/components.h"
#include "core/pipeline/grow_part.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/step_graph.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

namespace espalier {
namespace {

constexpr double longestLink = 8; // in point spacings
constexpr int linksPerPoint = 6;

/// The points of each connected part that is no crumb.
std::vector<std::vector<Eigen::Index>> partsOf(const PipelineState& region, double spacing,
                                               const Progress& progress) {
  const NeighborhoodGraph graph(region.cloud->positions(), linksPerPoint, progress);
  std::vector<bool> isMet(static_cast<std::size_t>(graph.size()), false);
  std::vector<std::vector<Eigen::Index>> parts;
  for (Eigen::Index i = 0; i < graph.size(); ++i) {
    if (isMet[static_cast<std::size_t>(i)]) continue;
    parts.push_back(pointsLinkedTo(graph, i, static_cast<float>(longestLink * spacing), isMet));
    if (parts.back().size() < fewestPoints) parts.pop_back();
  }
  return parts;
}

/// Some of the points of a region, as contracted there, with the nearest to the root as root.
PipelineState stateOf(const std::vector<Eigen::Index>& points, const PipelineState& region,
                      const std::vector<float>& distanceToRoot) {
  const auto nearest = std::ranges::min_element(points, {}, [&](Eigen::Index point) {
    return distanceToRoot[static_cast<std::size_t>(point)];
  });
  return {.cloud = someOf(*region.cloud, points),
          .isLeftOut = std::vector<bool>(points.size(), false),
          .contracted =
              std::make_shared<const Eigen::Matrix3Xf>((*region.contracted)(Eigen::all, points)),
          .root = nearest - points.begin(),
          .made = StepResult::contracted,
          .extent = region.extent};
}

/// Adds what of `part` lies in the ball. Nodes whose parent does not are roots.
void addInside(const Skeleton& part, const Ball& ball, Skeleton& result) {
  std::vector<std::optional<NodeId>> copies(part.idEnd());
  for (const NodeId id : part.ids()) {
    if (!ball.contains(part[id].position)) continue;
    Node copy = part[id];
    if (copy.parent) copy.parent = copies[indexOf(*copy.parent)];
    copies[indexOf(id)] = result.add(copy);
  }
}

} // namespace

Skeleton skeletonOfRegion(const PipelineState& region, const std::vector<float>& distanceToRoot,
                          const Ball& ball, const PipelineOptions& options,
                          const Progress& progress) {
  const PlantScale& scale = region.extent.scale;
  const std::vector<ChosenStep> steps =
      stepsBetween(StepResult::contracted, StepResult::skeleton, options, scale);
  const std::vector<std::vector<Eigen::Index>> parts =
      partsOf(region, scale.spacing, progress.part(0, 0.1));
  std::vector<std::shared_ptr<const Skeleton>> skeletons(parts.size()); // none where one failed
  std::vector<std::exception_ptr> failures(parts.size());
  const Progress stop = progress.part(0.1, 0.1); // the steps of parts report only when to stop
  const auto reconstruct = [&](Eigen::Index i) {
    const auto part = static_cast<std::size_t>(i);
    PipelineState state = stateOf(parts[part], region, distanceToRoot);
    try {
      runSteps(steps, state, stop);
      skeletons[part] = state.skeleton;
    } catch (const Error&) { // others may have a skeleton
      failures[part] = std::current_exception();
    }
  };
  parallelFor(static_cast<Eigen::Index>(parts.size()), reconstruct, progress.part(0.1, 1), 1);
  Skeleton result;
  for (const auto& skeleton : skeletons)
    if (skeleton) addInside(*skeleton, ball, result);
  const auto failure = std::ranges::find_if(failures, [](const auto& one) { return !!one; });
  if (result.isEmpty() && failure != failures.end()) std::rethrow_exception(*failure);
  return result;
}

} // namespace espalier
