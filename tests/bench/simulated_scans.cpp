#include "tests/bench/simulated_scans.h"

#include "core/base/counted_random.h"
#include "core/io/formats.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/simulate/prepared_plant.h"
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
                          {"arabidopsis", Architecture::herb, "arabidopsis"}};

double between(CountedRandom& random, double least, double most) {
  return least + (most - least) * random.uniform();
}

double evenlyInLog(CountedRandom& random, double least, double most) {
  return std::exp(between(random, std::log(least), std::log(most)));
}

Skeleton plantOf(const Kind& kind, CountedRandom& random, std::uint64_t number) {
  if (kind.file)
    if (const auto file =
            test::sharedFile(std::string("structures/") + kind.file + "_reference.mtg"))
      return preparedPlant(readStructure(*file).value.skeleton);
  const int segments = kind.architecture == Architecture::herb
                           ? static_cast<int>(evenlyInLog(random, 10, 60))
                           : static_cast<int>(evenlyInLog(random, 60, 500));
  return growPlant({.architecture = kind.architecture, .height = 4, .segments = segments}, number);
}

std::size_t segmentsOf(const Skeleton& plant) {
  std::size_t ends = 0;
  for (const NodeId id : plant.ids())
    ends += plant.children(id).size() != 1;
  return ends;
}

} // namespace

ScannedPlant scannedPlant(std::uint64_t number) {
  const Kind& kind = kinds[number % std::size(kinds)];
  CountedRandom random(number, 0);
  ScannedPlant plant{.name = std::string(kind.name) + " " + std::to_string(number)};
  plant.truth = plantOf(kind, random, number);
  plant.pointsPerSegment = evenlyInLog(random, 8, 600);
  Eigen::AlignedBox3d box;
  for (const NodeId id : plant.truth.ids())
    box.extend(plant.truth[id].position);
  constexpr int stations[] = {1, 2, 4, 4, 8};
  ScannerOptions scanner;
  scanner.points = static_cast<Eigen::Index>(std::clamp(
      plant.pointsPerSegment * static_cast<double>(segmentsOf(plant.truth)), 300.0, 300'000.0));
  scanner.stations = stations[static_cast<std::size_t>(between(random, 0, std::size(stations)))];
  scanner.rangeNoise = std::pow(between(random, 0, 1), 2) / 500 * box.sizes().maxCoeff();
  scanner.misalignment = std::min(*scanner.rangeNoise, box.sizes().maxCoeff() / 2500);
  scanner.clumps = random.uniform() < 0.5 ? 10 : 0;
  plant.foliage = random.uniform() < 0.6 ? 0 : between(random, 0.3, 2);
  scanner.foliage = foliageOf(kind.architecture, plant.foliage);
  plant.cloud = std::make_shared<const PointCloud>(scan(plant.truth, scanner, number).points);
  return plant;
}

} // namespace espalier
