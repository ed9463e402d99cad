#include "core/simulate/laser_scanner.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/shown.h"
#include "core/simulate/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace espalier {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using std::numbers::pi;

void requireOption(bool holds, const char* what) {
  if (!holds) throw Error(std::string("scanner options: ") + what);
}

bool isIn(double value, double least, double most) {
  return value >= least && value <= most; // no NaN is
}

void check(const ScannerOptions& options) {
  requireOption(options.points >= 10 && options.points <= 100'000'000,
                "expected 10 to 100000000 points");
  requireOption(options.stations >= 1 && options.stations <= 100, "expected 1 to 100 stations");
  requireOption(isIn(options.distance, 0.6, 100),
                "expected a distance of 0.6 to 100 plant extents");
  requireOption(isIn(options.elevation, -10, 10),
                "expected an elevation of -10 to 10 plant heights");
  requireOption(isIn(options.rangeNoise.value_or(0), 0, 1e300) &&
                    isIn(options.rangeNoiseInSteps, 0, 1e3),
                "expected a range noise of 0 or more");
  requireOption(isIn(options.misalignment.value_or(0), 0, 1e300),
                "expected a misalignment of 0 or more");
  requireOption(isIn(options.angularNoise, 0, 10), "expected an angular noise of 0 to 10 steps");
  requireOption(isIn(options.beamWidth, 0, 3), "expected a beam width of 0 to 3 steps");
  requireOption(isIn(options.grazingLoss, 0, 1), "expected a grazing loss of 0 to 1");
  requireOption(isIn(options.strayShare, 0, 0.5), "expected a share of stray points of 0 to 0.5");
  requireOption(options.clumps >= 0 && options.clumps <= 1000,
                "expected 0 to 1000 clumps of leaves");
  requireOption(isIn(options.clumpRadius, 0, 1), "expected a clump radius of 0 to 1 extents");
}

std::vector<Vector3d> stationsAround(const Eigen::AlignedBox3d& bounds, double extent,
                                     const ScannerOptions& options, Random& random) {
  const double any = random.uniform(0, 2 * pi);
  if (!options.at.empty()) return options.at;
  const double first = options.azimuth.value_or(any);
  std::vector<Vector3d> stations;
  for (int i = 0; i < options.stations; ++i) {
    const double azimuth = first + 2 * pi * i / options.stations;
    Vector3d station = bounds.center() + options.distance * extent *
                                             Vector3d(std::cos(azimuth), std::sin(azimuth), 0);
    station.z() = bounds.min().z() + options.elevation * bounds.sizes().z();
    stations.push_back(station);
  }
  return stations;
}

std::vector<LeafClump> clumpsIn(const std::vector<EdgeSolid>& wood, double extent,
                                const ScannerOptions& options, Random& random) {
  std::vector<LeafClump> clumps;
  clumps.reserve(static_cast<std::size_t>(options.clumps));
  for (int i = 0; i < options.clumps; ++i)
    clumps.push_back({wood[random.below(wood.size())].to, options.clumpRadius * extent});
  return clumps;
}

/// Where each station looks, and how far its scan is out of place.
std::vector<ScanWindow> windowsOf(const std::vector<Vector3d>& stations,
                                  const Eigen::AlignedBox3d& bounds, double misalignment,
                                  Random& random) {
  std::vector<ScanWindow> windows;
  for (const Vector3d& station : stations) {
    requireOption(station.allFinite(), "expected finite places of the stations");
    windows.push_back(windowOf(station, bounds));
    for (double& shift : windows.back().shift)
      shift = misalignment * random.normal();
  }
  return windows;
}

Eigen::AlignedBox3d boundsOfAll(const std::vector<EdgeSolid>& wood) {
  Eigen::AlignedBox3d bounds;
  for (const EdgeSolid& piece : wood)
    bounds.extend(boundsOf(piece));
  return bounds;
}

/// The beams of a station as rows of even elevation.
struct Sweep {
  ScanWindow window;
  Index rows = 0;
  Index columns = 0;
};

Sweep sweepOf(const ScanWindow& window, double step) {
  return {window, static_cast<Index>(std::ceil(window.height / step)),
          static_cast<Index>(std::ceil(window.width / step))};
}

/// Beams per echo: how many of a sample of all beams of this step come back.
/// @return echoes of all stations, expected for one beam per square radian
double echoDensity(const ScanScene& scene, const std::vector<ScanWindow>& windows, double step,
                   std::uint64_t seed, const Progress& progress) {
  constexpr Index side = 128; // sampled beams in each direction, per station
  double density = 0;
  for (std::size_t w = 0; w < windows.size(); ++w) {
    const ScanWindow& window = windows[w];
    std::vector<Index> echoes(side, 0);
    parallelFor(
        side,
        [&](Index row) {
          for (Index column = 0; column < side; ++column) {
            const auto number =
                static_cast<std::uint64_t>((static_cast<Index>(w) * side + row) * side + column);
            CountedRandom random(seed, number);
            const double u = (static_cast<double>(column) + random.uniform()) / side;
            const double v = (static_cast<double>(row) + random.uniform()) / side;
            if (echoOf(scene, window.station, window.azimuth + u * window.width,
                       window.elevation + v * window.height, step, random))
              ++echoes[static_cast<std::size_t>(row)];
          }
        },
        progress.part(static_cast<double>(w) / static_cast<double>(windows.size()),
                      static_cast<double>(w + 1) / static_cast<double>(windows.size())),
        8);
    Index sum = 0;
    for (const Index count : echoes)
      sum += count;
    density += static_cast<double>(sum) * window.width * window.height / (side * side);
  }
  return density;
}

/// The angle between beams that gives as many points as asked.
double angularStep(const ScanScene& scene, const std::vector<ScanWindow>& windows,
                   std::uint64_t seed, const Progress& progress) {
  const double echoes = static_cast<double>(scene.options.points) * (1 - scene.options.strayShare);
  double step = 0;
  for (const double part : {0.0, 0.5}) { // the width of the beams depends on the step
    const double density = echoDensity(scene, windows, step, seed, progress.part(part, part + 0.5));
    if (!(density > 0))
      throw Error("no beam of the scanner hits the plant: check the stations and the radii");
    step = std::sqrt(density / echoes);
  }
  return step;
}

struct StationEcho {
  Echo echo;
  StationIndex station;
};

/// All echoes in the order of stations, rows and columns.
std::vector<StationEcho> echoesOf(const ScanScene& scene, const std::vector<ScanWindow>& windows,
                                  double step, std::uint64_t seed, const Progress& progress) {
  std::vector<std::pair<std::size_t, Index>> rows; // window, row
  std::vector<Sweep> sweeps;
  for (std::size_t w = 0; w < windows.size(); ++w) {
    sweeps.push_back(sweepOf(windows[w], step));
    for (Index row = 0; row < sweeps[w].rows; ++row)
      rows.emplace_back(w, row);
  }
  std::vector<std::vector<StationEcho>> found(rows.size());
  parallelFor(
      static_cast<Index>(rows.size()),
      [&](Index i) {
        const auto [w, row] = rows[static_cast<std::size_t>(i)];
        const auto& [window, rowCount, columns] = sweeps[w];
        const double elevation = window.elevation + (static_cast<double>(row) + 0.5) * step;
        for (Index column = 0; column < columns; ++column) {
          const auto number =
              static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint64_t>(column);
          const double azimuth = window.azimuth + (static_cast<double>(column) + 0.5) * step;
          if (const auto echo = echoOf(scene, window.station, azimuth, elevation, step,
                                       CountedRandom(seed, number)))
            found[static_cast<std::size_t>(i)].push_back(
                {{echo->position + window.shift, echo->intensity, echo->node, echo->organ},
                 static_cast<StationIndex>(w)});
        }
      },
      progress, 4);
  std::vector<StationEcho> echoes;
  for (const std::vector<StationEcho>& row : found)
    echoes.insert(echoes.end(), row.begin(), row.end());
  return echoes;
}

/// Points on nothing, around the plant.
void addStrays(SimulatedScan& scan, double share, Eigen::AlignedBox3d bounds, Random& random) {
  const Vector3d margin = Vector3d::Constant(0.05 * bounds.sizes().maxCoeff());
  bounds = {bounds.min() - margin, bounds.max() + margin};
  const auto hits = static_cast<double>(scan.points.positions.size());
  for (auto left = std::lround(hits * share / (1 - share)); left > 0; --left) {
    Vector3d place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = random.uniform(bounds.min()[axis], bounds.max()[axis]);
    scan.points.positions.push_back(place);
    scan.points.intensities.push_back(static_cast<float>(0.3 * random.uniform()));
    scan.nodes.emplace_back();
    scan.organs.push_back(Organ::wood);
    scan.stationOf.push_back(
        static_cast<StationIndex>(scan.stationOf.size() % scan.stations.size())); // in turn
  }
}

} // namespace

SimulatedScan scan(const Skeleton& plant, const ScannerOptions& options, std::uint64_t seed,
                   const Progress& progress) {
  check(options);
  std::vector<EdgeSolid> pieces = woodOf(plant);
  if (pieces.empty()) throw Error("the plant has no edges: nothing to scan");
  Eigen::AlignedBox3d bounds = boundsOfAll(pieces); // of the plant alone: foliage moves no station
  const double extent = bounds.sizes().maxCoeff();
  Random random(seed);
  SimulatedScan result{.stations = stationsAround(bounds, extent, options, random)};
  std::vector<LeafClump> clumps = clumpsIn(pieces, extent, options, random);
  Organs organs = organsOf(plant, options.foliage, extent, seed + 3);
  pieces.insert(pieces.end(), organs.shortShoots.begin(), organs.shortShoots.end());
  pieces.insert(pieces.end(), organs.petioles.begin(), organs.petioles.end());
  const WoodIndex wood(pieces);
  result.blades = organs.blades;
  result.petioles = organs.petioles;
  const PieceTree<Blade> blades(organs.blades);
  const ScanScene scene{.wood = wood,
                        .blades = blades,
                        .options = options,
                        .clumps = std::move(clumps),
                        .extent = extent,
                        .rangeNoise = options.rangeNoise.value_or(extent / 2500)};
  bounds.extend(wood.bounds()).extend(blades.bounds());
  const std::vector<ScanWindow> windows =
      windowsOf(result.stations, bounds, options.misalignment.value_or(extent / 2500), random);
  result.angularStep =
      angularStep(scene, windows, seed + 1, progress.part(0, 0.15, Shown::tr("Simulated scan")));
  for (const auto& [echo, station] :
       echoesOf(scene, windows, result.angularStep, seed + 2,
                progress.part(0.15, 0.95, Shown::tr("Simulated scan")))) {
    result.points.positions.push_back(echo.position);
    result.points.intensities.push_back(echo.intensity);
    result.nodes.push_back(echo.node);
    result.organs.push_back(echo.organ);
    result.stationOf.push_back(station);
  }
  addStrays(result, options.strayShare, bounds, random);
  progress.update(1);
  return result;
}

std::vector<RawPoints> pointsByStation(const SimulatedScan& scan) {
  std::vector<RawPoints> stations(scan.stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i)
    stations[i].stations = {
        {.name = "station " + std::to_string(i + 1), .scanner = scan.stations[i]}};
  for (std::size_t i = 0; i < scan.stationOf.size(); ++i) {
    RawPoints& its = stations[scan.stationOf[i]];
    its.positions.push_back(scan.points.positions[i]);
    its.intensities.push_back(scan.points.intensities[i]);
  }
  return stations;
}

} // namespace espalier
