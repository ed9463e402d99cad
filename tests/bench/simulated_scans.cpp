#include "tests/bench/simulated_scans.h"

#include "core/io/formats.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/simulate/prepared_plant.h"
#include "tests/bench/scan_draws.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace espalier {
namespace {

struct Kind {
  const char* name;
  Architecture architecture;
  const char* file = nullptr; // of a structure; null: grown
  bool isLeafy = false;       // its leaves are large, and axes of its structure
};

constexpr Kind kinds[] = {{"broadleaf", Architecture::broadleaf},
                          {"conifer", Architecture::conifer},
                          {"puu3", Architecture::conifer, "puu3"},
                          {"shrub", Architecture::shrub},
                          {"herb", Architecture::herb},
                          {"cherry", Architecture::broadleaf, "cherry"},
                          {"broadleaf", Architecture::broadleaf},
                          {"conifer", Architecture::conifer},
                          {"puu3", Architecture::conifer, "puu3"},
                          {"shrub", Architecture::shrub},
                          {"herb", Architecture::herb},
                          {"arabidopsis", Architecture::herb, "arabidopsis"},
                          {"leafy herb", Architecture::herb, nullptr, true},
                          {"leafy herb", Architecture::herb, nullptr, true}};

Skeleton plantOf(const Kind& kind, CountedRandom& random, std::uint64_t number) {
  if (kind.file)
    if (const auto file =
            test::sharedFile(std::string("structures/") + kind.file + "_reference.mtg"))
      return preparedPlant(readStructure(*file).value.skeleton);
  const int segments = kind.isLeafy ? static_cast<int>(evenlyInLog(random, 2, 12))
                       : kind.architecture == Architecture::herb
                           ? static_cast<int>(evenlyInLog(random, 10, 60))
                           : static_cast<int>(evenlyInLog(random, 60, 500));
  return growPlant({.architecture = kind.architecture, .height = 4, .segments = segments}, number);
}

/// Few large leaves: seedlings, maize, tobacco.
Foliage largeLeaves(CountedRandom& random, const Skeleton& plant, double extent) {
  OrganHabit leaves;
  leaves.spacing = std::min(1.0, lengthOf(plant) / extent / evenlyInLog(random, 3, 20));
  leaves.length = evenlyInLog(random, 0.12, 0.6);
  leaves.width = leaves.length * evenlyInLog(random, 0.08, 0.7);
  leaves.angle = between(random, 0.4, 1.4);
  leaves.reach = 10;
  return {.blades = leaves};
}

/// A plant with the midribs of its leaves.
Skeleton withMidribs(const Skeleton& plant, const std::vector<Blade>& blades) {
  Skeleton all = plant;
  const std::vector<NodeId> ids = plant.ids();
  for (const Blade& blade : blades) {
    NodeId at = *std::ranges::min_element(
        ids, {}, [&](NodeId id) { return (plant[id].position - blade.base).squaredNorm(); });
    for (const double share : {0.25, 0.5, 0.75, 1.0})
      at = all.add(Node{.position = blade.base + share * blade.along, .parent = at});
  }
  return all;
}

/// What a scan is drawn from.
struct Draws {
  double fewest;        // points a segment
  double most;          // likewise
  double mostOfHerbs;   // likewise
  double mostPoints;    // of a scan
  bool isNoisy = false; // else: with little noise and with foliage, mostly
};

/// In extents. Some 3 mm is little of a tree, and much of a herb.
double noiseOf(CountedRandom& random, bool isNoisy, bool isHerb) {
  if (isNoisy)
    return isHerb ? evenlyInLog(random, 1.0 / 1000, 1.0 / 60)
                  : evenlyInLog(random, 1.0 / 2000, 1.0 / 200);
  return std::pow(between(random, 0, 1), 2) / 500;
}

ScannedPlant drawnPlant(std::uint64_t number, const Draws& draws) {
  const Kind& kind = kinds[number % std::size(kinds)];
  CountedRandom random(number, 0);
  ScannedPlant plant{.name = std::string(kind.name) + " " + std::to_string(number),
                     .isLeafy = kind.isLeafy};
  plant.truth = plantOf(kind, random, number);
  const bool isHerb = kind.architecture == Architecture::herb;
  plant.pointsPerSegment =
      evenlyInLog(random, draws.fewest, isHerb ? draws.mostOfHerbs : draws.most);
  Eigen::AlignedBox3d box;
  for (const NodeId id : plant.truth.ids())
    box.extend(plant.truth[id].position);
  constexpr int stations[] = {1, 2, 4, 4, 8};
  ScannerOptions scanner;
  scanner.points = static_cast<Eigen::Index>(
      std::clamp(plant.pointsPerSegment * static_cast<double>(segmentsOf(plant.truth)), 300.0,
                 draws.mostPoints));
  scanner.stations = stations[static_cast<std::size_t>(between(random, 0, std::size(stations)))];
  plant.noise = noiseOf(random, draws.isNoisy, isHerb) * box.sizes().maxCoeff();
  scanner.rangeNoise = plant.noise;
  scanner.misalignment = std::min(plant.noise, box.sizes().maxCoeff() / 2500);
  scanner.clumps = random.uniform() < 0.5 ? 10 : 0;
  plant.foliage = random.uniform() < 0.6 || draws.isNoisy ? 0 : between(random, 0.3, 2);
  scanner.foliage = kind.isLeafy ? largeLeaves(random, plant.truth, box.sizes().maxCoeff())
                                 : foliageOf(kind.architecture, plant.foliage);
  const SimulatedScan scanned = scan(plant.truth, scanner, number);
  plant.cloud = std::make_shared<const PointCloud>(scanned.points);
  for (const auto& node : scanned.nodes)
    if (node) plant.diameters.push_back(2 * plant.truth[*node].radius);
  if (!kind.isLeafy) return plant;
  plant.truth = withMidribs(plant.truth, scanned.blades);
  plant.pointsPerSegment =
      static_cast<double>(plant.cloud->size()) / static_cast<double>(segmentsOf(plant.truth));
  return plant;
}

} // namespace

ScannedPlant scannedPlant(std::uint64_t number) {
  return drawnPlant(number,
                    {.fewest = 8, .most = 600, .mostOfHerbs = 10'000, .mostPoints = 300'000});
}

ScannedPlant densePlant(std::uint64_t number) {
  return drawnPlant(number,
                    {.fewest = 400, .most = 8000, .mostOfHerbs = 40'000, .mostPoints = 250'000});
}

ScannedPlant noisyPlant(std::uint64_t number) {
  return drawnPlant(
      number,
      {.fewest = 100, .most = 1000, .mostOfHerbs = 10'000, .mostPoints = 100'000, .isNoisy = true});
}

} // namespace espalier
