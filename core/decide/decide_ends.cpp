#include "core/decide/decide_ends.h"

#include "core/skeleton/prune.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace espalier {
namespace {

using End = EndsOfSkeleton::End;

EndDecision decisionOn(const Skeleton& skeleton, const End& end, double probability, bool stays) {
  EndDecision decision{.path = {skeleton[end.end.foot].position},
                       .tip = end.end.nodes.front(),
                       .evidence = end.evidence,
                       .probability = probability,
                       .stays = stays};
  for (auto id = end.end.nodes.rbegin(); id != end.end.nodes.rend(); ++id)
    decision.path.push_back(skeleton[*id].position);
  return decision;
}

std::vector<double> probabilitiesOf(const std::vector<End>& ends,
                                    const ShootProbability& probability) {
  std::vector<double> probabilities;
  for (const End& end : ends)
    probabilities.push_back(probability(end.evidence));
  return probabilities;
}

/// Of each branching the least probable end, if it is too improbable.
std::vector<std::size_t> improbable(const std::vector<End>& ends,
                                    const std::vector<double>& probabilities, double least) {
  std::map<NodeId, std::size_t> worst; // by foot
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (probabilities[i] >= least) continue;
    const auto [at, isNew] = worst.try_emplace(ends[i].end.foot, i);
    if (!isNew && probabilities[i] < probabilities[at->second]) at->second = i;
  }
  std::vector<std::size_t> places;
  for (const auto& [foot, place] : worst)
    places.push_back(place);
  return places;
}

} // namespace

DecidedEnds withDecidedEnds(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                            const Eigen::Vector3d& origin, const PlantScale& scale,
                            const EndOptions& options, const Progress& progress,
                            const ShootProbability& probability) {
  DecidedEnds result{withoutSpurs(skeleton, {.length = options.length}), {}};
  if (result.skeleton.isEmpty() || points.cols() == 0) return result;
  EndsOfSkeleton ends(std::move(result.skeleton), points, origin, scale, progress.part(0, 0.7));
  std::vector<double> probabilities = probabilitiesOf(ends.ends(), probability);
  for (double done = 0.7;; done += (1 - done) / 2) {
    const auto gone = improbable(ends.ends(), probabilities, options.leastProbability);
    if (gone.empty()) break;
    for (const std::size_t i : gone)
      result.decisions.push_back(
          decisionOn(ends.skeleton(), ends.ends()[i], probabilities[i], false));
    ends.remove(gone, progress.part(done, (1 + done) / 2));
    probabilities = probabilitiesOf(ends.ends(), probability);
  }
  for (std::size_t i = 0; i < ends.ends().size(); ++i)
    result.decisions.push_back(decisionOn(ends.skeleton(), ends.ends()[i], probabilities[i], true));
  result.skeleton = ends.skeleton();
  progress.update(1);
  return result;
}

} // namespace espalier
