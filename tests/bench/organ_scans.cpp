#include "tests/bench/organ_scans.h"

#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/bench/scan_draws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

enum class Leaves : std::uint8_t { none, simple, needles, herb, compound, grass };

struct Kind {
  const char* name;
  Architecture architecture;
  Leaves leaves;
};

constexpr Kind kinds[] = {{"bare tree", Architecture::broadleaf, Leaves::none},
                          {"tree in leaf", Architecture::broadleaf, Leaves::simple},
                          {"conifer with needles", Architecture::conifer, Leaves::needles},
                          {"herb", Architecture::herb, Leaves::herb},
                          {"grass", Architecture::herb, Leaves::grass},
                          {"bare conifer", Architecture::conifer, Leaves::none},
                          {"shrub in leaf", Architecture::shrub, Leaves::simple},
                          {"conifer with needles", Architecture::conifer, Leaves::needles},
                          {"compound herb", Architecture::herb, Leaves::compound},
                          {"grass", Architecture::herb, Leaves::grass},
                          {"bare shrub", Architecture::shrub, Leaves::none}};

Foliage needlesOf(CountedRandom& random) { // dense as a pine's or as a thin larch's
  Foliage foliage = foliageOf(Architecture::conifer, evenlyInLog(random, 0.7, 5));
  foliage.blades.length = evenlyInLog(random, 0.005, 0.03);
  foliage.blades.width = foliage.blades.length * between(random, 0.03, 0.08);
  foliage.blades.reach = between(random, 0.06, 0.3);
  return foliage;
}

/// @param leaves  wanted of a plant of this length, in extents
Foliage leavesOf(CountedRandom& random, Leaves kind, double length, double leaves) {
  Foliage foliage;
  OrganHabit& blades = foliage.blades;
  blades.angle = between(random, 0.4, 1.4);
  blades.reach = kind == Leaves::simple ? between(random, 0.1, 0.3) : 10;
  blades.spacing = std::min(1.0, length / leaves);
  if (kind == Leaves::simple) {
    blades.spacing = evenlyInLog(random, 0.004, 0.03);
    blades.length = evenlyInLog(random, 0.012, 0.05);
    blades.width = blades.length * between(random, 0.3, 0.8);
    foliage.petiole = between(random, 0.1, 0.5);
  } else if (kind == Leaves::herb) {
    blades.length = evenlyInLog(random, 0.08, 0.35);
    blades.width = blades.length * between(random, 0.25, 0.9);
    foliage.petiole = between(random, 0.2, 1.2);
    foliage.droop = random.uniform() < 0.5 ? 0 : between(random, 0.3, 1.5);
  } else if (kind == Leaves::compound) {
    blades.length = evenlyInLog(random, 0.06, 0.15);
    blades.width = blades.length * between(random, 0.4, 0.8);
    foliage.petiole = between(random, 1.5, 4);
    foliage.leaflets = 1 + static_cast<int>(3.99 * random.uniform());
    foliage.droop = between(random, 0.2, 1);
  } else {
    blades.length = evenlyInLog(random, 0.25, 0.9);
    blades.width = blades.length * between(random, 0.04, 0.15);
    blades.angle = between(random, 0.3, 0.9);
    foliage.droop = between(random, 0.3, 2.2);
  }
  return foliage;
}

Foliage foliageFor(CountedRandom& random, Leaves kind, double length) {
  if (kind == Leaves::none) return {};
  if (kind == Leaves::needles) return needlesOf(random);
  return leavesOf(random, kind, length, evenlyInLog(random, 4, 25));
}

int segmentsWanted(CountedRandom& random, const Kind& kind) {
  if (kind.leaves == Leaves::grass) return static_cast<int>(evenlyInLog(random, 1, 4));
  if (kind.architecture == Architecture::herb) return static_cast<int>(evenlyInLog(random, 1, 12));
  return static_cast<int>(evenlyInLog(random, 60, 400));
}

/// Adds nodes from the one of `plant` that is nearest to `from`, evenly up to `to`.
void addLine(Skeleton& plant, const Eigen::Vector3d& from, const Eigen::Vector3d& to, int nodes) {
  const std::vector<NodeId> ids = plant.ids();
  NodeId at = *std::ranges::min_element(
      ids, {}, [&](NodeId id) { return (plant[id].position - from).squaredNorm(); });
  for (int i = 1; i <= nodes; ++i)
    at = plant.add(
        Node{.position = from + static_cast<double>(i) / nodes * (to - from), .parent = at});
}

/// A plant with its petioles and the midribs of its leaves: each begins at the end of what bears
/// it, and parts of a long leaf at the part before.
Skeleton withLeafAxes(const Skeleton& plant, const SimulatedScan& scanned, int leaflets) {
  Skeleton all = plant;
  for (const EdgeSolid& petiole : scanned.petioles)
    addLine(all, petiole.from, petiole.to, leaflets + 1);
  for (const Blade& blade : scanned.blades)
    addLine(all, blade.base, blade.base + blade.along, 4);
  return all;
}

} // namespace

OrganScan organScan(std::uint64_t number) {
  const Kind& kind = kinds[number % std::size(kinds)];
  CountedRandom random(number, 7);
  const bool isHerb = kind.architecture == Architecture::herb;
  GrowthOptions growth{
      .architecture = kind.architecture, .height = 4, .segments = segmentsWanted(random, kind)};
  if (isHerb) growth.baseRadius = growth.height * evenlyInLog(random, 0.004, 0.02);
  const Skeleton plant = growPlant(growth, number);
  Eigen::AlignedBox3d box;
  for (const NodeId id : plant.ids())
    box.extend(plant[id].position);
  const double extent = box.sizes().maxCoeff();
  const auto segments = static_cast<double>(segmentsOf(plant));
  constexpr int stations[] = {1, 2, 4, 4, 8};
  ScannerOptions scanner;
  scanner.stations = stations[static_cast<std::size_t>(between(random, 0, std::size(stations)))];
  scanner.points = static_cast<Eigen::Index>(
      isHerb ? evenlyInLog(random, 5'000, 120'000)
             : std::clamp(segments * evenlyInLog(random, 20, 600), 3'000.0, 120'000.0));
  scanner.rangeNoise = std::pow(random.uniform(), 2) / 500 * extent;
  scanner.misalignment = std::min(*scanner.rangeNoise, extent / 2500);
  scanner.foliage = foliageFor(random, kind.leaves, lengthOf(plant) / extent);
  const SimulatedScan scanned = scan(plant, scanner, number);
  OrganScan result{.kind = kind.name,
                   .cloud = std::make_shared<const PointCloud>(scanned.points),
                   .organs = {},
                   .pointsPerSegment = static_cast<double>(scanned.organs.size()) / segments,
                   .truth =
                       isHerb ? withLeafAxes(plant, scanned, scanner.foliage.leaflets) : plant};
  for (Eigen::Index i = 0; i < result.cloud->size(); ++i)
    result.organs.push_back(scanned.organs[result.cloud->fileOrder()[static_cast<std::size_t>(i)]]);
  return result;
}

} // namespace espalier
