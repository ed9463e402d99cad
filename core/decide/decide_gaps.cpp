#include "core/decide/decide_gaps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t mostAlternatives = 4;

/// Links that are alike.
struct LikeLinks {
  std::size_t place; // of the one that stands for them: the chosen one, else the most probable
  double probability;
};

/// @param places  of the links of one fragment
/// @param near    [L]: see isAlike()
GapDecision decisionOf(const Skeleton& skeleton, const Gaps& gaps, std::vector<std::size_t> places,
                       const std::vector<double>& probabilities, std::size_t chosen, double near) {
  std::ranges::stable_sort(places, std::greater(),
                           [&](std::size_t place) { return probabilities[place]; });
  std::vector<LikeLinks> all;
  for (const std::size_t place : places) {
    const auto like = std::ranges::find_if(all, [&](const LikeLinks& one) {
      return isAlike(skeleton, gaps.links[one.place], gaps.links[place], near);
    });
    if (like == all.end()) {
      all.push_back({place, probabilities[place]});
    } else {
      like->probability += probabilities[place];
      if (place == chosen) like->place = place;
    }
  }
  std::ranges::stable_sort(all, std::greater(), &LikeLinks::probability);
  GapDecision decision;
  for (const LikeLinks& one : all) {
    const bool isChosen = one.place == chosen;
    if (!isChosen && decision.alternatives.size() >= mostAlternatives) continue;
    if (isChosen) decision.chosen = decision.alternatives.size();
    const GapLink& link = gaps.links[one.place];
    decision.alternatives.push_back(
        {skeleton[link.from].position, skeleton[link.to].position, one.probability});
  }
  return decision;
}

} // namespace

DecidedGaps withDecidedGaps(const Skeleton& skeleton, double spacing, const Eigen::Vector3d& up,
                            const GapOptions& options, const Progress& progress,
                            const GapOdds& odds) {
  const Gaps gaps = gapsIn(skeleton, options, progress);
  const std::vector<double> probabilities = probabilitiesOf(gaps, spacing, up, odds);
  std::vector<double> costs;
  std::vector<std::vector<std::size_t>> ofFragment(gaps.entries.size());
  for (std::size_t i = 0; i < gaps.links.size(); ++i) {
    costs.push_back(-std::log(std::max(probabilities[i], std::numeric_limits<double>::min())));
    ofFragment[gaps.links[i].borne].push_back(i);
  }
  LinkedFragments linked = linkedBy(skeleton, gaps, costs);
  DecidedGaps result{std::move(linked.skeleton), {}};
  for (std::size_t fragment = 0; fragment < ofFragment.size(); ++fragment) {
    if (linked.chosen[fragment] < 0) continue;
    result.decisions.push_back(
        decisionOf(skeleton, gaps, std::move(ofFragment[fragment]), probabilities,
                   static_cast<std::size_t>(linked.chosen[fragment]), alikeWithin * spacing));
    result.decisions.back().nodes = gaps.nodes[fragment];
  }
  progress.update(1);
  return result;
}

} // namespace espalier
