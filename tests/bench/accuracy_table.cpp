// What each method reaches on simulated scans, a row each: the presets first, then every other
// method with all else as it is by default.
//
//   espalier_accuracy [--plants grown|structures|all|grid|any|dense|noisy|organs]
//                     [--first NUMBER] [--seeds N] [--foliage DENSITY] [--worst] [--radii]
//                     [ROW ...]
//
// A ROW is NAME:STEP.OPTION=VALUE,...; "6 spacings" is a length in point spacings; what it leaves
// out is as the preset of that name has it, else as by default. With rows,
// only they are printed. --worst prints each plant, too, --radii the errors of radii by how thick
// the wood is and how much of the way around it has points. Plants are bare, or have needles,
// leaves and short shoots that their truth lacks, 1 as dense as their kind bears them. A grid is of
// grown plants: each at three densities (points a segment), with three noises (in extents), bare
// and with foliage. "any" is 14 N plants of any kind, scanned in any way (simulated_scans.h), which
// espalier_fit_odds has not seen; a row each for sparse, middle and dense scans, bare, with
// foliage, and of herbs with large leaves. "dense" is 14 N of the same kinds, scanned more densely,
// in the same rows. "noisy" is 14 N of the same kinds, scanned densely with
// wide noise; a row each by how far their points are measured to scatter. "organs" is 11 N plants
// that espalier_fit_organs has not seen (organ_scans.h); a row each for their kinds. --first takes
// other plants and scans, from this number on, 1, and of "organs" 1001, if it is not said: what is
// chosen on some is judged on others.
//
// Columns: the authors' indices G and T; precision, recall and F within 4 spacings, and F within
// 2.5; segments found per true one; the share of the length on the same axis; median error of the
// radius, of wood over 2 spacings thick and of all, and its median with the sign; seconds a plant.
#include "core/base/error.h"
#include "core/evaluate/comparison.h"
#include "core/io/formats.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/presets.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/simulate/prepared_plant.h"
#include "tests/bench/judged_radii.h"
#include "tests/bench/organ_scans.h"
#include "tests/bench/simulated_scans.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace espalier {
namespace {

struct Plant {
  std::string name;
  Skeleton truth;
  std::shared_ptr<const PointCloud> cloud;
};

struct Row {
  std::string name;
  std::vector<std::string> settings;
  PipelineOptions options; // that these change
};

struct Reached {
  double geometric = 0;
  double structural = 0;
  double precision = 0;
  double recall = 0;
  double f = 0;
  double nearF = 0;
  double segments = 0;
  double axis = 0;
  double thickError = 0; // median, of wood over 2 spacings thick
  double radiusError = 0;
  double radiusBias = 0;
  double seconds = 0;
  std::vector<JudgedRadius> radii; // of all plants, where these are of several
};

/// Which plants.
struct Choice {
  std::string plants = "grown";
  std::uint64_t first = 0; // of the seeds; 0: not said
  int seeds = 3;
  double foliage = 0;
};

Plant scanned(std::string name, Skeleton truth, const ScannerOptions& scanner, std::uint64_t seed) {
  SimulatedScan result = scan(truth, scanner, seed);
  return {std::move(name), std::move(truth),
          std::make_shared<const PointCloud>(std::move(result.points))};
}

constexpr int pointsPerSegment[] = {60, 130, 260};
constexpr double noises[] = {0, 1.0 / 2500, 1.0 / 1000}; // in extents

/// How densely and with how much noise a plant is scanned: places in the lists above.
struct Quality {
  std::size_t density;
  std::size_t noise;
};

/// Another for each seed.
Quality qualityOf(std::uint64_t seed) {
  return {seed % 3, (seed / 3 + seed) % 3};
}

/// @param quality none: another for each seed
std::vector<Plant> grownPlants(const Choice& choice, double foliage,
                               std::optional<Quality> quality = {}) {
  std::vector<Plant> plants;
  const std::pair<const char*, Architecture> kinds[] = {{"broadleaf", Architecture::broadleaf},
                                                        {"conifer", Architecture::conifer},
                                                        {"shrub", Architecture::shrub},
                                                        {"herb", Architecture::herb}};
  for (const auto& [name, kind] : kinds)
    for (int i = 0; i < choice.seeds; ++i) {
      const int segments = kind == Architecture::herb ? 25 : 150;
      const std::uint64_t number = choice.first + static_cast<std::uint64_t>(i);
      const Quality used = quality.value_or(qualityOf(number));
      ScannerOptions scanner;
      scanner.points = pointsPerSegment[used.density] * segments;
      scanner.rangeNoise = 4 * noises[used.noise];
      scanner.clumps = number % 2 == 0 ? 10 : 0; // of leaves that hid wood
      scanner.foliage = foliageOf(kind, foliage);
      plants.push_back(
          scanned(name + std::string(" ") + std::to_string(number),
                  growPlant({.architecture = kind, .height = 4, .segments = segments}, number),
                  scanner, number));
    }
  return plants;
}

std::vector<Plant> structurePlants(const Choice& choice) {
  std::vector<Plant> plants;
  const std::tuple<std::string, Architecture, Eigen::Index> structures[] = {
      {"puu3", Architecture::conifer, 120'000},
      {"cherry", Architecture::broadleaf, 120'000},
      {"arabidopsis", Architecture::herb, 6'000}};
  for (const auto& [name, kind, points] : structures) {
    const auto file = test::sharedFile("structures/" + name + "_reference.mtg");
    if (!file) continue;
    const Skeleton truth = preparedPlant(readStructure(*file).value.skeleton);
    for (int i = 0; i < choice.seeds; ++i) {
      const std::uint64_t seed = choice.first + static_cast<std::uint64_t>(i);
      ScannerOptions scanner;
      scanner.points = points;
      if (seed % 2 == 0) scanner.clumps = 10;
      scanner.foliage = foliageOf(kind, choice.foliage);
      plants.push_back(scanned(name + " " + std::to_string(seed), truth, scanner, seed));
    }
  }
  return plants;
}

PipelineOptions optionsOf(const Row& row) {
  PipelineOptions options = row.options;
  for (const std::string& setting : row.settings)
    options.set(setting);
  return options;
}

Reached scoreOf(const Row& row, const Plant& plant) {
  using Clock = std::chrono::steady_clock;
  const double spacing = pointSpacing(plant.cloud->positions());
  const auto start = Clock::now();
  const Reconstruction result = Pipeline().run(plant.cloud, optionsOf(row));
  Reached score;
  score.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const Comparison comparison =
      compare(*result.skeleton, plant.truth,
              {.registers = false, .tolerance = {.distances = {2.5 * spacing, 4 * spacing}}});
  score.geometric = comparison.authors.geometric;
  score.structural = comparison.authors.structural;
  score.precision = comparison.tolerance.scores.back().precision;
  score.recall = comparison.tolerance.scores.back().recall;
  score.f = comparison.tolerance.scores.back().f();
  score.nearF = comparison.tolerance.scores.front().f();
  score.segments = static_cast<double>(comparison.authors.resultSegments.size()) /
                   static_cast<double>(comparison.authors.referenceSegments.size());
  score.axis = comparison.architecture.sameAxis;
  score.radii = judgedRadii(*result.skeleton, plant.truth, *plant.cloud, spacing);
  const RadiusErrors all = errorsOf(score.radii, {});
  score.radiusError = all.median;
  score.radiusBias = all.signedMedian;
  score.thickError = errorsOf(score.radii, {.thinnest = 2}).median;
  return score;
}

void print(const std::string& name, const Reached& score) {
  std::printf("%-34s %.3f %.3f  %.3f %.3f %.3f %.3f  %5.2f  %.3f  %5.3f %5.3f %6.3f  %6.2f\n",
              name.c_str(), score.geometric, score.structural, score.precision, score.recall,
              score.f, score.nearF, score.segments, score.axis, score.thickError, score.radiusError,
              score.radiusBias, score.seconds);
  std::fflush(stdout);
}

Reached meanOf(const std::vector<Reached>& scores) {
  Reached mean;
  for (double Reached::*member :
       {&Reached::geometric, &Reached::structural, &Reached::precision, &Reached::recall,
        &Reached::f, &Reached::nearF, &Reached::segments, &Reached::axis, &Reached::thickError,
        &Reached::radiusError, &Reached::radiusBias, &Reached::seconds})
    for (const Reached& score : scores)
      mean.*member += score.*member / static_cast<double>(scores.size());
  for (const Reached& score : scores)
    mean.radii.insert(mean.radii.end(), score.radii.begin(), score.radii.end());
  return mean;
}

std::vector<Row> allMethods() {
  std::vector<Row> rows;
  for (const NamedPreset& preset : presets())
    rows.push_back({preset.name, {}, preset.options});
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      if (&method != &step.methods.front())
        rows.push_back({step.name + "." + method.name, {step.name + ".method=" + method.name}, {}});
  return rows;
}

Row rowOf(const std::string& text) {
  const std::size_t colon = text.find(':');
  Row row{text.substr(0, colon), {}, {}};
  if (const NamedPreset* preset = presetNamed(row.name)) row.options = preset->options;
  std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    row.settings.push_back(rest.substr(0, comma));
    rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
  }
  return row;
}

/// What is printed besides the means.
struct Details {
  bool plants = false;
  bool radii = false;
};

void printRow(const Row& row, const std::vector<Plant>& plants, const Details& details) {
  std::vector<Reached> scores;
  for (const Plant& plant : plants) {
    try {
      scores.push_back(scoreOf(row, plant));
      if (details.plants) print(row.name + ", " + plant.name, scores.back());
    } catch (const Error& problem) {
      std::printf("%s, %s: %s\n", row.name.c_str(), plant.name.c_str(), problem.what());
    }
  }
  if (scores.empty()) return;
  const Reached mean = meanOf(scores);
  print(row.name, mean);
  if (details.radii) printRadii(mean.radii);
}

/// Each row at each density with each noise, bare and with foliage.
void printGrid(const std::vector<Row>& rows, const Choice& choice, const Details& details) {
  for (const double foliage : {0.0, 1.0})
    for (std::size_t density = 0; density < std::size(pointsPerSegment); ++density)
      for (std::size_t noise = 0; noise < std::size(noises); ++noise) {
        const std::vector<Plant> plants = grownPlants(choice, foliage, Quality{density, noise});
        for (Row row : rows) {
          row.name += foliage > 0 ? ", leafy, " : ", bare, ";
          row.name += std::to_string(pointsPerSegment[density]) + " pts, ";
          row.name += noises[noise] > 0 ? "1/" + std::to_string(std::lround(1 / noises[noise]))
                                        : "no noise";
          printRow(row, plants, details);
        }
      }
}

std::string cellByDensity(const ScannedPlant& plant) {
  return std::string(plant.pointsPerSegment < 60     ? "1 sparse"
                     : plant.pointsPerSegment < 300  ? "2 middle"
                     : plant.pointsPerSegment < 1000 ? "3 dense"
                                                     : "4 very dense") +
         (plant.isLeafy       ? ", leaves"
          : plant.foliage > 0 ? ", foliage"
                              : ", bare");
}

std::string cellByScatter(const ScannedPlant& plant) {
  const PlantScale scale = scaleOf(*plant.cloud, {}, UpAxis::z);
  const double scatter = scale.scatter / scale.spacing;
  return scatter < 1 ? "1 under 1 sp" : scatter < 2 ? "2 to 2 sp" : "3 over 2 sp";
}

/// Each row over plants of any kind that were scanned alike.
void printAny(const std::vector<Row>& rows, const Choice& choice, const Details& details) {
  constexpr std::uint64_t unseen = 1000; // espalier_fit_odds takes lower numbers
  const bool isNoisy = choice.plants == "noisy";
  std::map<std::string, std::vector<Plant>> cells;
  for (std::uint64_t i = 0; i < 14 * static_cast<std::uint64_t>(choice.seeds); ++i) {
    const std::uint64_t number = unseen + choice.first + i;
    ScannedPlant plant = isNoisy                    ? noisyPlant(number)
                         : choice.plants == "dense" ? densePlant(number)
                                                    : scannedPlant(number);
    const std::string cell = isNoisy ? cellByScatter(plant) : cellByDensity(plant);
    cells[cell].push_back({plant.name, std::move(plant.truth), std::move(plant.cloud)});
  }
  for (const auto& [cell, plants] : cells)
    for (Row row : rows) {
      row.name += " " + cell + " (" + std::to_string(plants.size()) + ")";
      printRow(row, plants, details);
    }
}

/// Each row over plants of each kind, with leaves or without.
void printOrgans(const std::vector<Row>& rows, const Choice& choice, const Details& details) {
  std::map<std::string, std::vector<Plant>> kinds;
  for (std::uint64_t i = 0; i < 11 * static_cast<std::uint64_t>(choice.seeds); ++i) {
    OrganScan plant = organScan(choice.first + i);
    kinds[plant.kind].push_back({plant.kind + " " + std::to_string(choice.first + i),
                                 std::move(plant.truth), std::move(plant.cloud)});
  }
  for (const auto& [kind, plants] : kinds)
    for (Row row : rows) {
      row.name += " " + kind + " (" + std::to_string(plants.size()) + ")";
      printRow(row, plants, details);
    }
}

void run(const std::vector<std::string>& arguments) {
  Choice choice;
  Details details;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--plants")
      choice.plants = arguments.at(++i);
    else if (arguments[i] == "--seeds")
      choice.seeds = std::stoi(arguments.at(++i));
    else if (arguments[i] == "--first")
      choice.first = std::stoull(arguments.at(++i));
    else if (arguments[i] == "--foliage")
      choice.foliage = std::stod(arguments.at(++i));
    else if (arguments[i] == "--worst")
      details.plants = true;
    else if (arguments[i] == "--radii")
      details.radii = true;
    else
      rows.push_back(rowOf(arguments[i]));
  }
  if (rows.empty()) rows = allMethods();
  if (choice.first == 0) choice.first = choice.plants == "organs" ? 1001 : 1;
  std::printf("%-34s %-5s %-5s  %-5s %-5s %-5s %-5s  %-5s  %-5s  %-5s %-5s %-6s  %6s\n", "", "G",
              "T", "P", "R", "F4", "F2.5", "segm.", "axis", "thick", "radii", "bias", "s");
  if (choice.plants == "grid") {
    printGrid(rows, choice, details);
    return;
  }
  if (choice.plants == "any" || choice.plants == "dense" || choice.plants == "noisy") {
    printAny(rows, choice, details);
    return;
  }
  if (choice.plants == "organs") {
    printOrgans(rows, choice, details);
    return;
  }
  std::vector<Plant> plants;
  if (choice.plants != "structures") plants = grownPlants(choice, choice.foliage);
  if (choice.plants != "grown")
    std::ranges::move(structurePlants(choice), std::back_inserter(plants));
  for (const Row& row : rows)
    printRow(row, plants, details);
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  try {
    espalier::run(std::vector<std::string>(argv + 1, argv + argc));
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
