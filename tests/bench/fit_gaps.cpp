// Fits the odds of links over gaps, the numbers in core/decide/gap_odds.cpp, on simulated scans,
// and shows on others how often links are right of which the odds say so.
//
//   espalier_fit_gaps [--plants N] [--others M]
//
// N plants, 120 if it is not said, are fitted on, the next M, 60, are judged by. Fitted are gaps of
// over five spacings: there are many more short ones, which are easy. A link is right if
// in the truth the wood that it bears is attached to the place it comes from, with hardly any other
// scanned wood between; fragments that no link bears so are passed over. Each plant weighs as the
// root of its fragments.
#include "core/decide/gap_odds.h"
#include "core/doubt/reference_places.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/pipeline.h"
#include "tests/bench/fit_main.h"
#include "tests/bench/fitted_logit.h"
#include "tests/bench/fitted_quadratic.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Choice = LinkChoice<GapOdds().weights.size()>;

/// Which links are right: in the truth the wood is attached to the place, with hardly any other
/// wood between. Empty where none is.
std::vector<bool> rightOf(const std::vector<WoodFrom>& links, const ReferencePlaces& truth,
                          double spacing) {
  double lowest = std::numeric_limits<double>::infinity(); // where the wood may be entered
  for (const WoodFrom& link : links)
    lowest = std::min(lowest, truth.nearest(link.to).depth);
  std::vector<double> lengths; // along the plant, of those that it has
  for (const WoodFrom& link : links) {
    const auto to = truth.nearest(link.to);
    const ReferencePlace from = truth.below(to, link.from);
    const double near = 3 * spacing + 1.5 * truth.radiusAt(truth.nearest(link.from));
    const bool isOn = from.distance < near && to.depth < lowest + 6 * spacing;
    lengths.push_back(isOn ? to.depth - from.depth : std::numeric_limits<double>::infinity());
  }
  const double least = *std::ranges::min_element(lengths);
  if (!std::isfinite(least)) return {};
  std::vector<bool> isRight;
  for (const double length : lengths)
    isRight.push_back(std::isfinite(length) && length < 1.2 * least + 4 * spacing);
  return isRight;
}

std::vector<Choice> choicesOf(std::uint64_t number) {
  const ScannedPlant plant = scannedPlant(number);
  const Reconstruction found = Pipeline().run(plant.cloud, {}, {}, "skeleton");
  const Skeleton& skeleton = *found.skeleton;
  const double spacing = found.scale.spacing;
  GapOptions options;
  options.widest = 5 * spacing;
  options.reach = options.reach.rule().value(found.scale);
  options.backCost = options.backCost.rule().value(found.scale);
  const Gaps gaps = gapsIn(skeleton, options);
  const ReferencePlaces truth(plant.truth);
  std::map<std::uint32_t, std::vector<const GapLink*>> byFragment;
  for (const GapLink& link : gaps.links)
    byFragment[link.borne].push_back(&link);
  std::vector<Choice> choices;
  for (const auto& [fragment, links] : byFragment) {
    std::vector<WoodFrom> judged;
    for (const GapLink* link : links)
      judged.push_back({skeleton[link->from].position, skeleton[link->to].position});
    Choice choice{.links = {}, .isRight = rightOf(judged, truth, spacing)};
    if (choice.isRight.empty()) continue;
    choice.alike.resize(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
      choice.links.push_back(featuresOf(links[i]->evidence, spacing, Eigen::Vector3d::UnitZ()));
      for (std::size_t k = 0; k < links.size(); ++k)
        if (k != i && isAlike(skeleton, *links[i], *links[k], alikeWithin * spacing))
          choice.alike[i].push_back(k);
    }
    choices.push_back(std::move(choice));
  }
  for (Choice& choice : choices)
    choice.weight = 1 / std::sqrt(static_cast<double>(choices.size()));
  return choices;
}

/// The place of the cheapest link.
std::size_t cheapest(const Choice& choice) {
  const auto found =
      std::ranges::min_element(choice.links, {}, [](const auto& link) { return link.back(); });
  return static_cast<std::size_t>(found - choice.links.begin());
}

int fitGaps(const FitCounts& counts) {
  const std::vector<Choice> choices = ofPlants(1, counts.lastFitted(), choicesOf);
  const GapOdds odds = fittedLogit(choices);
  std::printf("%zu fragments\n", choices.size());
  printQuadratic(odds);
  printReliability(choices, odds, "cheapest", cheapest);
  std::printf("of others:\n");
  printReliability(ofPlants(counts.lastFitted() + 1, counts.lastJudged(), choicesOf), odds,
                   "cheapest", cheapest);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  return espalier::fitGaps(espalier::fitCounts(argc, argv));
}
