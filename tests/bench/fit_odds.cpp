// Fits the odds of ends, the numbers in core/decide/fitted_end_odds.cpp, on simulated scans, and
// shows on others how often ends are shoots of which the odds say so.
//
//   espalier_fit_odds [--alone] [--plants N] [--others M] [--rounds R]
//   espalier_fit_odds --check FROM TO
//   espalier_fit_odds --judge SCAN REFERENCE [SCAN REFERENCE ...]
//
// Without --alone the odds of an end among all ends of its plant, with it those of an end by
// itself. N plants, 540 if it is not said and 180 of --alone, are fitted on, the next M, 180 and
// 90, are judged by (fit_plants.h). An end is labelled a shoot if the measure of the method's
// authors matches its segment to one of the truth. Examples are the ends of skeletons before any
// are taken away, and in later rounds (3) also those that are there after they were taken away by
// the odds of the round before: what is asked in between. Each plant weighs as the root of its
// examples.
//
// --check fits nothing: it shows how often the odds by which ends are decided, up to halfway
// between both, are right on plants from number FROM to before TO, as 541 721. --judge, likewise,
// on real scans, whose references are laid on what is found; of each pair alone.
#include "core/cloud/point_set.h"
#include "core/decide/decide_ends.h"
#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "tests/bench/fit_plants.h"
#include "tests/bench/fitted_quadratic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr double shortest = 2.5; // [spacings] shorter ends are not asked about

struct Example {
  EndEvidence evidence;
  bool isShoot = false;
  double weight = 1;
};

/// What is there to decide on.
struct Case {
  ScannedPlant plant;
  Skeleton skeleton;
  Eigen::Matrix3Xf points;
  PlantScale scale;
};

/// Those that the skeleton was made of.
Eigen::Matrix3Xf pointsOf(const std::shared_ptr<const PointCloud>& cloud,
                          const Reconstruction& result) {
  return result.apart ? without(*cloud, *result.apart).positions() : cloud->positions();
}

std::optional<Case> caseOf(std::uint64_t number) try {
  Case found{.plant = plantForFit(number)};
  const Reconstruction result = Pipeline().run(found.plant.cloud, {}, {}, "join");
  found.skeleton = *result.skeleton;
  found.scale = result.scale;
  found.points = pointsOf(found.plant.cloud, result);
  return found;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%d: %s\n", static_cast<int>(number), error.what());
  return std::nullopt;
}

/// The ends that stay, with their labels.
std::vector<Example> examplesOf(const Case& of, double leastProbability,
                                const ShootProbability& probability) {
  const DecidedEnds decided = withDecidedEnds(
      of.skeleton, of.points, of.plant.cloud->origin(), of.scale,
      {.leastProbability = leastProbability, .length = Length(shortest * of.scale.spacing)}, {},
      probability);
  const AuthorsComparison comparison = authorsComparison(decided.skeleton, of.plant.truth);
  std::set<NodeId> matched;
  for (const auto& match : comparison.matches)
    matched.insert(comparison.resultSegments[match.result].nodes.back());
  std::vector<Example> examples;
  for (const EndDecision& decision : decided.decisions)
    if (decision.stays) examples.push_back({decision.evidence, matched.contains(decision.tip)});
  return examples;
}

void append(std::vector<Example>& all, std::vector<Example> some) {
  for (Example& example : some) {
    example.weight = 1 / std::sqrt(static_cast<double>(some.size()));
    all.push_back(example);
  }
}

template <std::size_t Features>
std::vector<LabelledFeatures<Features>>
labelled(const std::vector<Example>& examples,
         std::array<double, Features> (*features)(const EndEvidence&)) {
  std::vector<LabelledFeatures<Features>> all;
  all.reserve(examples.size());
  for (const Example& example : examples)
    all.push_back({features(example.evidence), example.isShoot ? 1.0 : 0.0, example.weight});
  return all;
}

/// What is fitted: the probability that follows, and how it is printed.
struct Fitted {
  ShootProbability probability;
  std::function<void()> print;
};

Fitted fitted(const std::vector<Example>& examples, bool isAlone) {
  if (isAlone) {
    const EndOdds odds = fittedQuadratic(labelled(examples, featuresOf));
    return {[odds](const EndEvidence& end) { return probabilityOfShoot(end, odds); },
            [odds] { printQuadratic(odds); }};
  }
  const OddsAmongAll odds = fittedWholeQuadratic(labelled(examples, featuresAmongAll));
  return {[odds](const EndEvidence& end) {
            return 1 / (1 + std::exp(-odds.value(featuresAmongAll(end))));
          },
          [odds] { printQuadratic(odds); }};
}

/// A reliability diagram as a table, and the expected calibration error.
void printReliability(const std::vector<Example>& examples, const ShootProbability& odds) {
  struct Bin {
    double weight = 0, said = 0, were = 0;
    int count = 0;
  };
  std::array<Bin, 10> bins;
  double all = 0, wrong = 0;
  for (const Example& example : examples) {
    const double probability = odds(example.evidence);
    Bin& bin = bins[std::min<std::size_t>(9, static_cast<std::size_t>(10 * probability))];
    bin.weight += example.weight;
    bin.said += example.weight * probability;
    bin.were += example.weight * example.isShoot;
    ++bin.count;
    all += example.weight;
    wrong += example.weight * ((probability >= 0.5) != example.isShoot);
  }
  double error = 0;
  std::printf("  ends  said  were\n");
  for (const Bin& bin : bins) {
    if (bin.count == 0) continue;
    std::printf("%6d  %.3f %.3f\n", bin.count, bin.said / bin.weight, bin.were / bin.weight);
    error += std::abs(bin.said - bin.were) / all;
  }
  std::printf("expected calibration error %.3f, wrong at one half %.3f\n", error, wrong / all);
}

/// A real scan, with the structure that an expert made of it.
Case caseOf(const std::string& scan, const std::string& reference) {
  Case found;
  found.plant.cloud = std::make_shared<const PointCloud>(readPoints(scan).value);
  const Reconstruction result = Pipeline().run(found.plant.cloud, {}, {}, "join");
  found.skeleton = *result.skeleton;
  found.scale = result.scale;
  found.points = pointsOf(found.plant.cloud, result);
  Skeleton truth = readStructure(reference).value.skeleton;
  const Registration lies = registration(found.skeleton, truth);
  found.plant.truth = moved(std::move(truth), lies.motion.inverse());
  return found;
}

void judge(const std::string& scan, const std::string& reference) {
  const Case one = caseOf(scan, reference);
  const auto show = [&](const char* which, double least) {
    std::vector<Example> examples;
    append(examples, examplesOf(one, least, probabilityAmongAll));
    std::printf("%s, %s:\n", scan.c_str(), which);
    printReliability(examples, probabilityAmongAll);
  };
  show("before any is taken away", 0);
  show("that stay by default", EndOptions().leastProbability);
  show("that stay at 0.5", 0.5);
}

std::vector<Case> casesOf(std::uint64_t from, std::uint64_t to) {
  std::vector<Case> cases;
  for (std::uint64_t number = from; number < to; ++number)
    if (auto found = caseOf(number)) cases.push_back(std::move(*found));
  return cases;
}

/// How often ends are shoots, of plants from one number to before another.
void printOnOthers(std::uint64_t from, std::uint64_t to, const ShootProbability& probability) {
  std::vector<Example> before, after;
  for (const Case& one : casesOf(from, to)) {
    append(before, examplesOf(one, 0, probability));
    append(after, examplesOf(one, 0.5, probability));
  }
  std::printf("of others, before any is taken away:\n");
  printReliability(before, probability);
  std::printf("of others, that stay:\n");
  printReliability(after, probability);
}

int fitOdds(bool isAlone, int plants, int others, int rounds) {
  const auto count = static_cast<std::uint64_t>(plants);
  const std::vector<Case> cases = casesOf(1, count + 1);
  std::vector<Example> examples;
  for (const Case& one : cases)
    append(examples, examplesOf(one, 0, probabilityAmongAll));
  Fitted odds = fitted(examples, isAlone);
  for (int round = 1; round < rounds; ++round) {
    for (const Case& one : cases)
      for (const double least : {0.2, 0.5})
        append(examples, examplesOf(one, least, odds.probability));
    odds = fitted(examples, isAlone);
  }
  std::printf("%zu examples of %zu plants\n", examples.size(), cases.size());
  odds.print();
  std::printf("of these plants, all examples:\n");
  printReliability(examples, odds.probability);
  printOnOthers(count + 1, count + 1 + static_cast<std::uint64_t>(others), odds.probability);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) try {
  if (argc == 4 && std::string(argv[1]) == "--check") {
    espalier::printOnOthers(std::strtoull(argv[2], nullptr, 10),
                            std::strtoull(argv[3], nullptr, 10), espalier::probabilityAmongAll);
    return 0;
  }
  if (argc > 1 && std::string(argv[1]) == "--judge") {
    for (int i = 2; i + 1 < argc; i += 2)
      espalier::judge(argv[i], argv[i + 1]);
    return 0;
  }
  const bool isAlone = argc > 1 && std::string(argv[1]) == "--alone";
  int plants = isAlone ? 180 : 540, others = isAlone ? 90 : 180, rounds = 3;
  for (int i = isAlone ? 2 : 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    int& value = name == "--plants" ? plants : name == "--others" ? others : rounds;
    value = std::atoi(argv[i + 1]);
  }
  return espalier::fitOdds(isAlone, plants, others, rounds);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
