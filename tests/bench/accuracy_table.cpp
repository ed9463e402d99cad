// What each method reaches on simulated scans, a row each: the presets first, then every other
// method with all else as it is by default.
//
//   espalier_accuracy [--plants grown|structures|all|grid] [--seeds N] [--worst] [ROW ...]
//
// A ROW is NAME:STEP.OPTION=VALUE,...; "6 spacings" is a length in point spacings. With rows,
// only they are printed. --worst prints each plant, too. A grid
// is of grown plants: each at three densities (points a segment), with three noises (in extents).
//
// Columns: the authors' indices G and T; precision, recall and F within 4 spacings; the
// share of the length on the same axis; median error of the radius, of wood over 2 spacings thick
// and of all, and its median with the sign; seconds a plant.
#include "core/base/error.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/edge_index.h"
#include "core/io/formats.h"
#include "core/pipeline/presets.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/simulate/prepared_plant.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
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

struct Score {
  double geometric = 0;
  double structural = 0;
  double precision = 0;
  double recall = 0;
  double f = 0;
  double axis = 0;
  double thickError = 0; // median, of wood over 2 spacings thick
  double radiusError = 0;
  double radiusBias = 0;
  double seconds = 0;
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
std::vector<Plant> grownPlants(int seeds, std::optional<Quality> quality = {}) {
  std::vector<Plant> plants;
  const std::pair<const char*, Architecture> kinds[] = {{"broadleaf", Architecture::broadleaf},
                                                        {"conifer", Architecture::conifer},
                                                        {"shrub", Architecture::shrub},
                                                        {"herb", Architecture::herb}};
  for (const auto& [name, kind] : kinds)
    for (int seed = 1; seed <= seeds; ++seed) {
      const int segments = kind == Architecture::herb ? 25 : 150;
      const auto number = static_cast<std::uint64_t>(seed);
      const Quality used = quality.value_or(qualityOf(number));
      ScannerOptions scanner;
      scanner.points = pointsPerSegment[used.density] * segments;
      scanner.rangeNoise = 4 * noises[used.noise];
      scanner.clumps = seed % 2 == 0 ? 10 : 0; // of leaves that hid wood
      plants.push_back(
          scanned(name + std::string(" ") + std::to_string(seed),
                  growPlant({.architecture = kind, .height = 4, .segments = segments}, number),
                  scanner, number));
    }
  return plants;
}

std::vector<Plant> structurePlants(int seeds) {
  std::vector<Plant> plants;
  for (const char* name : {"puu3", "cherry", "arabidopsis"}) {
    const auto file = test::sharedFile("structures/" + std::string(name) + "_reference.mtg");
    if (!file) continue;
    const Skeleton truth = preparedPlant(readStructure(*file).value.skeleton);
    for (int seed = 1; seed <= seeds; ++seed) {
      ScannerOptions scanner;
      scanner.points = std::strcmp(name, "arabidopsis") == 0 ? 6'000 : 120'000;
      if (seed % 2 == 0) scanner.clumps = 10;
      plants.push_back(scanned(name + std::string(" ") + std::to_string(seed), truth, scanner,
                               static_cast<std::uint64_t>(seed)));
    }
  }
  return plants;
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Relative errors of radii at the nodes of the result that lie within the true wood or near it.
void judgeRadii(const Skeleton& result, const Skeleton& truth, double spacing, Score& score) {
  const EdgeIndex index(truth);
  std::vector<double> all;
  std::vector<double> thick;
  std::vector<double> biases;
  for (const NodeId id : result.ids()) {
    const auto place = index.nearest(result[id].position);
    if (!place) continue;
    const Node& upper = truth[place->node];
    double radius = upper.radius;
    if (upper.parent && upper.edge == EdgeType::successor) {
      const Node& lower = truth[*upper.parent];
      const double length = (upper.position - lower.position).norm();
      const double share = length > 0 ? (upper.position - place->position).norm() / length : 0;
      radius = (1 - share) * upper.radius + share * lower.radius;
    }
    if (place->distance > radius + spacing) continue;
    const double error = std::abs(result[id].radius / radius - 1);
    all.push_back(error);
    biases.push_back(result[id].radius / radius - 1);
    if (radius > 2 * spacing) thick.push_back(error);
  }
  score.radiusError = medianOf(all);
  score.radiusBias = medianOf(biases);
  score.thickError = medianOf(thick);
}

PipelineOptions optionsOf(const Row& row) {
  PipelineOptions options = row.options;
  for (const std::string& setting : row.settings)
    options.set(setting);
  return options;
}

Score scoreOf(const Row& row, const Plant& plant) {
  using Clock = std::chrono::steady_clock;
  const double spacing = pointSpacing(plant.cloud->positions());
  const auto start = Clock::now();
  const Reconstruction result = Pipeline().run(plant.cloud, optionsOf(row));
  Score score;
  score.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const Comparison comparison =
      compare(result.skeleton, plant.truth,
              {.registers = false, .tolerance = {.distances = {4 * spacing}}});
  score.geometric = comparison.authors.geometric;
  score.structural = comparison.authors.structural;
  score.precision = comparison.tolerance.scores.front().precision;
  score.recall = comparison.tolerance.scores.front().recall;
  score.f = comparison.tolerance.scores.front().f();
  score.axis = comparison.architecture.sameAxis;
  judgeRadii(result.skeleton, plant.truth, spacing, score);
  return score;
}

void print(const std::string& name, const Score& score) {
  std::printf("%-34s %.3f %.3f  %.3f %.3f %.3f  %.3f  %5.3f %5.3f %6.3f  %6.2f\n", name.c_str(),
              score.geometric, score.structural, score.precision, score.recall, score.f, score.axis,
              score.thickError, score.radiusError, score.radiusBias, score.seconds);
  std::fflush(stdout);
}

Score meanOf(const std::vector<Score>& scores) {
  Score mean;
  for (double Score::*member :
       {&Score::geometric, &Score::structural, &Score::precision, &Score::recall, &Score::f,
        &Score::axis, &Score::thickError, &Score::radiusError, &Score::radiusBias, &Score::seconds})
    for (const Score& score : scores)
      mean.*member += score.*member / static_cast<double>(scores.size());
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
  std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    row.settings.push_back(rest.substr(0, comma));
    rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
  }
  return row;
}

void printRow(const Row& row, const std::vector<Plant>& plants, bool printsEach) {
  std::vector<Score> scores;
  for (const Plant& plant : plants) {
    try {
      scores.push_back(scoreOf(row, plant));
      if (printsEach) print(row.name + ", " + plant.name, scores.back());
    } catch (const Error& problem) {
      std::printf("%s, %s: %s\n", row.name.c_str(), plant.name.c_str(), problem.what());
    }
  }
  if (!scores.empty()) print(row.name, meanOf(scores));
}

/// Each row at each density with each noise.
void printGrid(const std::vector<Row>& rows, int seeds, bool printsEach) {
  for (std::size_t density = 0; density < std::size(pointsPerSegment); ++density)
    for (std::size_t noise = 0; noise < std::size(noises); ++noise) {
      const std::vector<Plant> plants = grownPlants(seeds, Quality{density, noise});
      for (Row row : rows) {
        row.name += ", " + std::to_string(pointsPerSegment[density]) + " pts, noise ";
        row.name += noises[noise] > 0 ? "1/" + std::to_string(std::lround(1 / noises[noise])) : "0";
        printRow(row, plants, printsEach);
      }
    }
}

void run(const std::vector<std::string>& arguments) {
  std::string which = "grown";
  int seeds = 3;
  bool printsEach = false;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--plants")
      which = arguments.at(++i);
    else if (arguments[i] == "--seeds")
      seeds = std::stoi(arguments.at(++i));
    else if (arguments[i] == "--worst")
      printsEach = true;
    else
      rows.push_back(rowOf(arguments[i]));
  }
  if (rows.empty()) rows = allMethods();
  std::printf("%-34s %-5s %-5s  %-5s %-5s %-5s  %-5s  %-5s %-5s %-6s  %6s\n", "", "G", "T", "P",
              "R", "F4", "axis", "thick", "radii", "bias", "s");
  if (which == "grid") {
    printGrid(rows, seeds, printsEach);
    return;
  }
  std::vector<Plant> plants;
  if (which != "structures") plants = grownPlants(seeds);
  if (which != "grown") std::ranges::move(structurePlants(seeds), std::back_inserter(plants));
  for (const Row& row : rows)
    printRow(row, plants, printsEach);
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
