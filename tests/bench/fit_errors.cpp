// Fits the odds of errors, the numbers in core/decide/error_odds.cpp, on simulated scans, and shows
// on others how much of what is wrong lies in the part that is rated riskiest.
//
//   espalier_fit_errors [--plants N] [--others M] [--examples FILE]
//   espalier_fit_errors --judge SCAN REFERENCE [STRUCTURE]
//
// N plants, 120 if it is not said, are fitted on, the next M, 60, are judged by: those of
// espalier_fit_odds. Examples are the pieces of the skeletons that are found by default and as in
// the thesis, each with the share of its length that is invented or wrongly attached
// (core/evaluate/differences, within 4 spacings). Each plant weighs as the root of its length.
// FILE keeps the examples: it is written, or read if it is there.
//
// --judge fits nothing: it shows the same of a real scan, whose reference is laid on what is found
// by default, or on STRUCTURE.
#include "core/decide/error_odds.h"
#include "core/evaluate/differences/differences.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/presets.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/length_along.h"
#include "tests/bench/fitted_quadratic.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace espalier {
namespace {

struct Piece {
  ErrorEvidence evidence;
  double length = 0; // [spacings]
  double wrong = 0;  // share of it
};

/// What was found of one scan.
struct Plant {
  std::uint64_t number = 0;
  double missed = 0;     // length of the truth, as a share of it
  double missedNear = 0; // of that, within 10 spacings of points that have no wood
  int clusters = 0;
  double reach = 0; // of these from end to end, in lengths of the truth
  std::vector<Piece> pieces;
};

Plant judged(const Skeleton& skeleton, const Skeleton& truth,
             const std::shared_ptr<const PointCloud>& cloud, std::uint64_t number) {
  const PlantScale scale = scaleOf(*cloud, {}, UpAxis::z);
  const SpatialIndex index(cloud->positions());
  const PointDistances distances(cloud, scale.spacing, skeleton);
  const std::vector<Stretch> pieces = stretches(skeleton, ratedLength(scale));
  const std::vector<ErrorEvidence> evidence =
      errorEvidence(skeleton, pieces, distances, index, scale, Eigen::Vector3d::UnitZ());
  const Differences found = differences(skeleton, truth, 4 * scale.spacing);
  Plant plant{.number = number};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece piece{.evidence = evidence[i]};
    double wrong = 0;
    for (const NodeId id : pieces[i]) {
      const double length = edgeLength(skeleton, id) / scale.spacing;
      piece.length += length;
      if (found.ofResult[indexOf(id)] != Difference::matched) wrong += length;
    }
    if (piece.length == 0) continue;
    piece.wrong = wrong / piece.length;
    plant.pieces.push_back(piece);
  }
  const std::vector<Finding> clusters = pointsWithoutWood(
      skeleton, distances, scale.spacing, {.scatter = scale.scatter / scale.spacing});
  plant.clusters = static_cast<int>(clusters.size());
  Eigen::Matrix3Xf far(3, 0);
  for (const Finding& cluster : clusters) {
    plant.reach += 2 * cluster.reach;
    const Eigen::Index before = far.cols();
    far.conservativeResize(3, before + static_cast<Eigen::Index>(cluster.points.size()));
    far.rightCols(static_cast<Eigen::Index>(cluster.points.size())) =
        cloud->positions()(Eigen::all, cluster.points);
  }
  const SpatialIndex farIndex(far);
  double all = 0;
  for (const NodeId id : truth.ids()) {
    const double length = edgeLength(truth, id);
    all += length;
    if (found.ofReference[indexOf(id)] == Difference::matched || length == 0) continue;
    plant.missed += length;
    const Eigen::Vector3d middle =
        (truth[id].position + truth[*truth[id].parent].position) / 2 - cloud->origin();
    if (far.cols() > 0 &&
        farIndex.nearestOne(middle.cast<float>(), static_cast<float>(10 * scale.spacing)))
      plant.missedNear += length;
  }
  plant.missed /= all;
  plant.missedNear /= all;
  plant.reach /= all;
  return plant;
}

std::vector<Plant> plantsOf(std::uint64_t from, std::uint64_t to) {
  std::vector<Plant> plants;
  for (std::uint64_t number = from; number < to; ++number) {
    try {
      const ScannedPlant plant = scannedPlant(number);
      std::vector<PipelineOptions> choices = {{}};
      if (number % 3 == 0) choices.push_back(presets().at(1).options);
      for (const PipelineOptions& options : choices) {
        const Reconstruction result = Pipeline().run(plant.cloud, options);
        plants.push_back(judged(*result.skeleton, plant.truth, plant.cloud, number));
      }
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%d: %s\n", static_cast<int>(number), error.what());
    }
  }
  return plants;
}

using Rating = std::function<double(const ErrorEvidence&)>;

/// Of what is wrong, how much lies in the riskiest part of each plant; plants count by what is
/// wrong of them.
double shareFound(const std::vector<Plant>& plants, const Rating& rating, double part) {
  double wrong = 0, found = 0;
  for (const Plant& plant : plants) {
    std::vector<const Piece*> pieces;
    double all = 0;
    for (const Piece& piece : plant.pieces) {
      pieces.push_back(&piece);
      all += piece.length;
    }
    std::ranges::stable_sort(pieces, std::greater<>(),
                             [&](const Piece* piece) { return rating(piece->evidence); });
    double left = part * all;
    for (const Piece* piece : pieces) {
      wrong += piece->wrong * piece->length / all;
      const double taken = std::min(left, piece->length);
      found += piece->wrong * taken / all;
      left -= taken;
    }
  }
  return wrong > 0 ? found / wrong : 0;
}

void printShares(const std::vector<Plant>& plants, const ErrorOdds& odds) {
  struct Row {
    const char* name;
    Rating rating;
  };
  const Row rows[] = {
      {"by odds", [&](const ErrorEvidence& each) { return probabilityOfError(each, odds); }},
      {"by checks alone",
       [](const ErrorEvidence& each) {
         return each.findings + (each.withoutOwn > 0 ? 1 : 0) + (each.inAir > 0.5 ? 1 : 0);
       }},
      {"by odds of ends alone",
       [](const ErrorEvidence& each) { return each.isEnd ? -each.end : -1e3; }},
      {"thinnest first", [](const ErrorEvidence& each) { return -each.radius; }},
  };
  constexpr double parts[] = {0.02, 0.05, 0.1, 0.2, 0.3, 0.5};
  std::printf("%-24s", "riskiest part of length");
  for (const double part : parts)
    std::printf(" %5.0f%%", 100 * part);
  std::printf("\n");
  for (const Row& row : rows) {
    std::printf("%-24s", row.name);
    for (const double part : parts)
      std::printf(" %6.3f", shareFound(plants, row.rating, part));
    std::printf("\n");
  }
  double wrong = 0, missed = 0, near = 0, clusters = 0, reach = 0;
  for (const Plant& plant : plants) {
    double all = 0, own = 0;
    for (const Piece& piece : plant.pieces) {
      all += piece.length;
      own += piece.wrong * piece.length;
    }
    wrong += own / all;
    missed += plant.missed;
    near += plant.missedNear;
    clusters += plant.clusters;
    reach += plant.reach;
  }
  const auto count = static_cast<double>(plants.size());
  std::printf("wrong of the length %.3f; missed %.3f, %.3f of that near points that have no wood, "
              "%.1f clusters a plant, that reaches %.3f of how far they do\n",
              wrong / count, missed / count, missed > 0 ? near / missed : 0, clusters / count,
              reach > 0 ? near / reach : 0);
}

/// A reliability diagram as a table, and how much of the length and of what is wrong lies above.
void printReliability(const std::vector<Plant>& plants, const ErrorOdds& odds) {
  constexpr double limits[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1};
  struct Bin {
    double length = 0, said = 0, wrong = 0;
  };
  std::vector<Bin> bins(std::size(limits));
  Bin whole;
  for (const Plant& plant : plants) {
    double all = 0;
    for (const Piece& piece : plant.pieces)
      all += piece.length;
    for (const Piece& piece : plant.pieces) {
      const double said = probabilityOfError(piece.evidence, odds);
      const auto bin = std::ranges::lower_bound(limits, said) - std::begin(limits);
      for (Bin* each : {&bins[static_cast<std::size_t>(bin)], &whole}) {
        each->length += piece.length / all;
        each->said += said * piece.length / all;
        each->wrong += piece.wrong * piece.length / all;
      }
    }
  }
  std::printf(" up to  length    said    were   wrong below\n");
  Bin below;
  double error = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const Bin& bin = bins[i];
    below.length += bin.length;
    below.wrong += bin.wrong;
    error += std::abs(bin.said - bin.wrong) / whole.length;
    if (bin.length > 0)
      std::printf("%6.2f  %6.3f  %6.3f  %6.3f  %6.3f\n", limits[i], below.length / whole.length,
                  bin.said / bin.length, bin.wrong / bin.length, below.wrong / whole.wrong);
  }
  std::printf("expected calibration error %.3f\n", error);
}

using Examples = std::vector<LabelledFeatures<ErrorOdds().weights.size()>>;

Examples examplesOf(const std::vector<Plant>& plants) {
  Examples examples;
  for (const Plant& plant : plants) {
    double all = 0;
    for (const Piece& piece : plant.pieces)
      all += piece.length;
    for (const Piece& piece : plant.pieces)
      examples.push_back({featuresOf(piece.evidence), piece.wrong, piece.length / std::sqrt(all)});
  }
  return examples;
}

/// As usualFeatures() in the sources.
void printUsual(Examples examples) {
  for (auto& example : examples)
    example.weight *= 1 - example.label; // the share of it that is right
  std::printf("usual = {");
  for (std::size_t i = 0; i < usualFeatures().size(); ++i)
    std::printf("%s%.4f", i ? ", " : "", quantile(sortedValues(examples, i), 0.5));
  std::printf("};\n");
}

constexpr double ErrorEvidence::*numbers[] = {
    &ErrorEvidence::length, &ErrorEvidence::whole,      &ErrorEvidence::carried,
    &ErrorEvidence::points, &ErrorEvidence::scatter,    &ErrorEvidence::unexplained,
    &ErrorEvidence::inAir,  &ErrorEvidence::withoutOwn, &ErrorEvidence::beside,
    &ErrorEvidence::radius, &ErrorEvidence::turn,       &ErrorEvidence::findings,
    &ErrorEvidence::end,    &ErrorEvidence::gap};
constexpr bool ErrorEvidence::*flags[] = {&ErrorEvidence::branches, &ErrorEvidence::isEnd};

void write(const std::vector<Plant>& plants, const std::string& path) {
  std::ofstream file(path);
  file.precision(17);
  for (const Plant& plant : plants) {
    file << plant.number << ' ' << plant.missed << ' ' << plant.missedNear << ' ' << plant.clusters
         << ' ' << plant.reach << ' ' << plant.pieces.size() << '\n';
    for (const Piece& piece : plant.pieces) {
      file << piece.length << ' ' << piece.wrong;
      for (const auto number : numbers)
        file << ' ' << piece.evidence.*number;
      for (const auto flag : flags)
        file << ' ' << piece.evidence.*flag;
      file << '\n';
    }
  }
}

std::vector<Plant> readExamples(const std::string& path) {
  std::ifstream file(path);
  std::vector<Plant> plants;
  Plant plant;
  std::size_t pieces = 0;
  while (file >> plant.number >> plant.missed >> plant.missedNear >> plant.clusters >>
         plant.reach >> pieces) {
    plant.pieces.assign(pieces, {});
    for (Piece& piece : plant.pieces) {
      file >> piece.length >> piece.wrong;
      for (const auto number : numbers)
        file >> piece.evidence.*number;
      for (const auto flag : flags)
        file >> piece.evidence.*flag;
    }
    plants.push_back(plant);
  }
  return plants;
}

int fitErrors(std::uint64_t plants, std::uint64_t others, const std::string& kept) {
  std::vector<Plant> all;
  if (!kept.empty()) all = readExamples(kept);
  if (all.empty()) {
    all = plantsOf(1, plants + others + 1);
    if (!kept.empty()) write(all, kept);
  }
  const auto split =
      std::ranges::find_if(all, [&](const Plant& plant) { return plant.number > plants; });
  const std::vector<Plant> ones(all.begin(), split);
  const std::vector<Plant> rest(split, all.end());
  const Examples examples = examplesOf(ones);
  const ErrorOdds odds = fittedQuadratic(examples);
  std::printf("%zu skeletons\n", ones.size());
  printQuadratic(odds);
  printUsual(examples);
  std::printf("of these:\n");
  printShares(ones, odds);
  printReliability(ones, odds);
  std::printf("of %zu others:\n", rest.size());
  printShares(rest, odds);
  printReliability(rest, odds);
  return 0;
}

int judge(const std::string& scan, const std::string& reference, const std::string& structure) {
  const auto cloud = std::make_shared<const PointCloud>(readPoints(scan).value);
  const Skeleton found = structure.empty() ? *Pipeline().run(cloud, {}).skeleton
                                           : readStructure(structure).value.skeleton;
  Skeleton truth = readStructure(reference).value.skeleton;
  const Registration lies = registration(found, truth);
  const std::vector<Plant> plants = {
      judged(found, moved(std::move(truth), lies.motion.inverse()), cloud, 0)};
  printShares(plants, fittedErrorOdds());
  printReliability(plants, fittedErrorOdds());
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) try {
  if (argc > 3 && std::string(argv[1]) == "--judge")
    return espalier::judge(argv[2], argv[3], argc > 4 ? argv[4] : "");
  std::uint64_t plants = 120, others = 60;
  std::string kept;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--examples")
      kept = argv[i + 1];
    else
      (name == "--plants" ? plants : others) = std::strtoull(argv[i + 1], nullptr, 10);
  }
  return espalier::fitErrors(plants, others, kept);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
