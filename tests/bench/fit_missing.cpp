// Fits the odds of branches that are missing, the numbers in core/doubt/fitted_missing_odds.cpp, on
// simulated scans, and shows on others how often there is wood where the odds say so.
//
//   espalier_fit_missing [--plants N] [--others M]
//
// N plants (fit_plants.h), 300 if it is not said, are fitted on, the next M, 150, are judged by.
// There is wood if who has the truth says so (core/doubt/oracle.h), three spacings being near. Each
// plant weighs as the root of its branches.
#include "core/doubt/missing_branches.h"
#include "core/doubt/oracle.h"
#include "core/pipeline/pipeline.h"
#include "tests/bench/fit_main.h"
#include "tests/bench/fit_plants.h"
#include "tests/bench/fitted_quadratic.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace espalier {
namespace {

using Example = LabelledFeatures<15>;

std::vector<Example> examplesOf(std::uint64_t number) {
  const ScannedPlant plant = plantForFit(number);
  const Reconstruction found = Pipeline().run(plant.cloud);
  const Skeleton& skeleton = *found.skeleton;
  const SpatialIndex index(plant.cloud->positions());
  const PointDistances distances(plant.cloud, found.scale.spacing, skeleton);
  const Oracle oracle(plant.truth, 3 * found.scale.spacing);
  std::vector<Example> examples;
  for (const MissingBranch& missing :
       missingBranches(skeleton, {.distances = distances, .index = index, .scale = found.scale})) {
    Doubt doubt{.kind = Doubt::Kind::missing, .node = missing.branch.on};
    doubt.alternatives = {{.kind = Alternative::Kind::asItIs},
                          {.kind = Alternative::Kind::add, .branch = missing.branch}};
    examples.push_back({featuresOf(missing), oracle.answer(skeleton, doubt) == 1 ? 1.0 : 0.0});
  }
  for (Example& example : examples)
    example.weight = 1 / std::sqrt(static_cast<double>(examples.size()));
  return examples;
}

/// A reliability diagram as a table, and the expected calibration error.
void printReliability(const std::vector<Example>& examples, const MissingOdds& odds) {
  struct Bin {
    double said = 0, were = 0;
    int count = 0;
  };
  std::array<Bin, 10> bins;
  for (const Example& example : examples) {
    const double said = 1 / (1 + std::exp(-odds.value(example.values)));
    Bin& bin = bins[std::min<std::size_t>(9, static_cast<std::size_t>(10 * said))];
    bin.said += said;
    bin.were += example.label;
    ++bin.count;
  }
  double error = 0;
  std::printf(" branches  said  were\n");
  for (const Bin& bin : bins) {
    if (bin.count == 0) continue;
    std::printf("%9d  %.3f %.3f\n", bin.count, bin.said / bin.count, bin.were / bin.count);
    error += std::abs(bin.said - bin.were) / static_cast<double>(examples.size());
  }
  std::printf("expected calibration error %.3f\n", error);
}

int fitMissing(const FitCounts& counts) {
  const std::vector<Example> examples = ofPlants(1, counts.lastFitted(), examplesOf);
  const MissingOdds odds = fittedWholeQuadratic(examples);
  std::printf("%zu branches\n", examples.size());
  printQuadratic(odds);
  printReliability(examples, odds);
  std::printf("of others:\n");
  printReliability(ofPlants(counts.lastFitted() + 1, counts.lastJudged(), examplesOf), odds);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  return espalier::fitMissing(espalier::fitCounts(argc, argv, {.plants = 300, .others = 150}));
}
