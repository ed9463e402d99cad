// Fits the odds of attachments, the numbers in core/decide/attachment_odds.cpp, on simulated scans,
// and shows on others how often links are right of which the odds say so.
//
//   espalier_fit_attachments [--plants N] [--others M]
//
// N plants, 120 if it is not said, are fitted on, the next M, 60, are judged by. A link is right if
// in the truth the wood grows from the place it comes from, with hardly any other wood between;
// wood that is none in the truth, or that no link bears so, is passed over. Each plant weighs as
// the root of its choices.
#include "core/decide/attachment_odds.h"
#include "core/doubt/reference_places.h"
#include "core/pipeline/pipeline.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/length_along.h"
#include "tests/bench/fit_main.h"
#include "tests/bench/fitted_logit.h"
#include "tests/bench/fitted_quadratic.h"
#include "tests/bench/simulated_scans.h"

#include <cmath>
#include <cstdio>
#include <vector>

namespace espalier {
namespace {

using Choice = LinkChoice<AttachmentOdds().weights.size()>;

/// A place a little farther up the wood, where it is not mistaken for what it touches at its foot.
Eigen::Vector3d upOn(const Skeleton& skeleton, NodeId id, double distance) {
  for (double length = 0; length < distance;) {
    const auto next = nextOnAxis(skeleton, id);
    if (!next) break;
    id = *next;
    length += edgeLength(skeleton, id);
  }
  return skeleton[id].position;
}

std::vector<Choice> choicesOf(std::uint64_t number) {
  const ScannedPlant plant = scannedPlant(number);
  const Reconstruction found = Pipeline().run(plant.cloud);
  const Skeleton& skeleton = *found.skeleton;
  const double spacing = found.scale.spacing;
  const Eigen::Matrix3Xf& positions = plant.cloud->positions();
  const SpatialIndex index(positions);
  const ReferencePlaces truth(plant.truth);
  std::vector<Choice> choices;
  for (const AttachmentChoice& asked : attachmentChoices(skeleton, index, plant.cloud->origin(),
                                                         spacing, Eigen::Vector3d::UnitZ())) {
    const Eigen::Vector3d to = upOn(skeleton, asked.node, 8 * spacing);
    const auto place = truth.nearest(to);
    if (place.distance > 3 * spacing + 1.5 * truth.radiusAt(place)) continue;
    std::vector<WoodFrom> links;
    for (const AttachmentLink& link : asked.links)
      links.push_back({skeleton[link.from].position, to});
    const std::vector<double> detour = detours(links, truth, 3 * spacing);
    Choice choice;
    for (const double length : detour)
      choice.isRight.push_back(length <= 1.5 * spacing);
    if (std::ranges::count(choice.isRight, true) == 0) continue;
    for (const AttachmentLink& link : asked.links)
      choice.links.push_back(featuresOf(link.evidence));
    choices.push_back(std::move(choice));
  }
  for (Choice& choice : choices)
    choice.weight = 1 / std::sqrt(static_cast<double>(choices.size()));
  return choices;
}

int fitAttachments(const FitCounts& counts) {
  const std::vector<Choice> choices = ofPlants(1, counts.lastFitted(), choicesOf);
  const AttachmentOdds odds = fittedLogit(choices);
  const auto asItWas = [](const Choice&) { return std::size_t{0}; };
  std::printf("%zu choices\n", choices.size());
  printQuadratic(odds);
  printReliability(choices, odds, "present", asItWas);
  std::printf("of others:\n");
  printReliability(ofPlants(counts.lastFitted() + 1, counts.lastJudged(), choicesOf), odds,
                   "present", asItWas);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  return espalier::fitAttachments(espalier::fitCounts(argc, argv));
}
