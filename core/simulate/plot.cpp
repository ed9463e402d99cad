#include "core/simulate/plot.h"

#include "core/base/counted_random.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/simulate/piece_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace espalier {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

void requirePlot(bool holds, const char* what) {
  if (!holds) throw Error(std::string("plot options: ") + what);
}

bool isWithin(double value, double least, double most) {
  return value >= least && value <= most; // no NaN is
}

void check(const PlotOptions& options) {
  requirePlot(options.plants >= 1 && options.plants <= 1000, "expected 1 to 1000 plants");
  requirePlot(isWithin(options.heightSpread, 0, 0.9), "expected a spread of heights of 0 to 0.9");
  requirePlot(isWithin(options.spacing, 0.05, 100), "expected a spacing of 0.05 to 100 heights");
  requirePlot(isWithin(options.slope, 0, 1), "expected a slope of 0 to 1 rad");
  requirePlot(isWithin(options.bumps, 0, 1), "expected bumps of 0 to 1 heights");
  requirePlot(isWithin(options.groundShare, 0, 0.95), "expected a share of ground of 0 to 0.95");
  requirePlot(options.poles >= 0 && options.poles <= 100, "expected 0 to 100 poles");
  requirePlot(options.wires >= 0 && options.wires <= 100, "expected 0 to 100 wires");
  requirePlot(isWithin(options.poleHeight, 0.01, 10), "expected poles of 0.01 to 10 heights");
  requirePlot(options.poleRadius > 0 && options.poleRadius <= 1,
              "expected poles of a radius of up to 1 height");
  requirePlot(options.wireRadius > 0 && options.wireRadius <= 1,
              "expected wires of a radius of up to 1 height");
}

/// A slope with bumps.
class PlotGround {
public:
  PlotGround(const PlotOptions& options, Random& random) {
    const double towards = random.uniform(0, 2 * pi);
    rise_ = std::tan(options.slope) * Eigen::Vector2d(std::cos(towards), std::sin(towards));
    for (Wave& wave : waves_) {
      const double angle = random.uniform(0, 2 * pi);
      const double length = random.uniform(0.5, 2) * options.growth.height;
      wave.number = 2 * pi / length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      wave.phase = random.uniform(0, 2 * pi);
      wave.height = options.bumps * options.growth.height / 2;
    }
  }
  [[nodiscard]] double at(double x, double y) const {
    const Eigen::Vector2d place(x, y);
    double height = rise_.dot(place);
    for (const Wave& wave : waves_)
      height += wave.height * std::sin(wave.number.dot(place) + wave.phase);
    return height;
  }

private:
  struct Wave {
    Eigen::Vector2d number; // [1 / L]
    double phase = 0, height = 0;
  };
  Eigen::Vector2d rise_;
  std::array<Wave, 3> waves_;
};

/// All that stands in a plot as one forest.
struct PlotForest {
  Skeleton skeleton;
  std::vector<PlotPoint> parts; // by id
  std::vector<Skeleton> plants;
  std::vector<Vector3d> bases, tops; // of plants, of poles

  NodeId add(const Node& node, const PlotPoint& part) {
    const NodeId id = skeleton.add(node);
    parts.resize(indexOf(id) + 1);
    parts[indexOf(id)] = part;
    return id;
  }
};

/// Places of plants in rows about the middle.
std::vector<Eigen::Vector2d> placesInRows(const PlotOptions& options, Random& random) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(options.plants)));
  const double apart = options.spacing * options.growth.height;
  std::vector<Eigen::Vector2d> places;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (int i = 0; i < options.plants; ++i) {
    const Eigen::Vector2d off(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
    places.emplace_back(apart * (Eigen::Vector2d(i % columns, i / columns) + off));
    middle += places.back() / options.plants;
  }
  for (Eigen::Vector2d& place : places)
    place -= middle;
  return places;
}

void addPlants(PlotForest& forest, const PlotOptions& options, const PlotGround& ground,
               const std::vector<Eigen::Vector2d>& places, std::uint64_t seed, Random& random,
               const Progress& progress) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    GrowthOptions growth = options.growth;
    growth.height *= 1 + options.heightSpread * random.uniform(-1, 1);
    const Skeleton grown =
        growPlant(growth, seed * 1009 + i,
                  progress.part(static_cast<double>(i) / static_cast<double>(places.size()),
                                static_cast<double>(i + 1) / static_cast<double>(places.size())));
    const Vector3d base(places[i].x(), places[i].y(), ground.at(places[i].x(), places[i].y()));
    const Eigen::AngleAxisd turn(random.uniform(0, 2 * pi), Vector3d::UnitZ());
    const PlotPoint part{PlotPart::plant, static_cast<std::uint32_t>(i + 1)};
    std::vector<NodeId> inForest(grown.idEnd());
    std::vector<NodeId> alone(grown.idEnd());
    Skeleton plant;
    for (const NodeId id : grown.ids()) {
      Node node = grown[id];
      node.position = base + turn * node.position;
      Node own = node;
      if (node.parent) {
        own.parent = alone[indexOf(*node.parent)];
        node.parent = inForest[indexOf(*node.parent)];
      }
      alone[indexOf(id)] = plant.add(own);
      inForest[indexOf(id)] = forest.add(node, part);
    }
    forest.plants.push_back(std::move(plant));
    forest.bases.push_back(base);
  }
}

/// A chain of nodes of one radius.
void addLine(PlotForest& forest, const std::vector<Vector3d>& places, double radius,
             PlotPart part) {
  std::optional<NodeId> last;
  for (const Vector3d& place : places)
    last = forest.add({.position = place, .radius = radius, .parent = last}, {.part = part});
}

/// The place in the plot that is farthest from all that stands there.
Eigen::Vector2d freePlace(const std::vector<Eigen::Vector2d>& taken, double halfSide,
                          Random& random) {
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double farthest = -1;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d place(random.uniform(-halfSide, halfSide),
                                random.uniform(-halfSide, halfSide));
    double nearest = 2 * halfSide;
    for (const Eigen::Vector2d& other : taken)
      nearest = std::min(nearest, (place - other).norm());
    if (nearest <= farthest) continue;
    farthest = nearest;
    best = place;
  }
  return best;
}

void addPoles(PlotForest& forest, const PlotOptions& options, const PlotGround& ground,
              std::vector<Eigen::Vector2d> taken, double halfSide, Random& random) {
  const double height = options.poleHeight * options.growth.height;
  for (int i = 0; i < options.poles; ++i) {
    const Eigen::Vector2d at = freePlace(taken, 0.6 * halfSide, random);
    taken.push_back(at);
    const Vector3d foot(at.x(), at.y(), ground.at(at.x(), at.y()));
    const Vector3d lean(0.05 * random.normal(), 0.05 * random.normal(), 1);
    std::vector<Vector3d> places;
    for (int k = 0; k <= 8; ++k)
      places.emplace_back(foot + height * k / 8 * lean.normalized());
    addLine(forest, places, options.poleRadius * options.growth.height, PlotPart::pole);
    forest.tops.push_back(places.back());
  }
}

/// Catenaries that sag by 1 to 5 % of their span.
void addWires(PlotForest& forest, const PlotOptions& options, const PlotGround& ground,
              double halfSide, Random& random) {
  constexpr int edges = 60;
  for (int i = 0; i < options.wires; ++i) {
    const double towards = random.uniform(0, 2 * pi);
    const double high = options.poleHeight * options.growth.height;
    const Eigen::Vector2d far =
        1.2 * halfSide * Eigen::Vector2d(std::cos(towards), std::sin(towards));
    Vector3d from(-far.x(), -far.y(), ground.at(-far.x(), -far.y()) + high);
    const Vector3d to(far.x(), far.y(), ground.at(far.x(), far.y()) + high);
    if (!forest.tops.empty()) from = forest.tops[static_cast<std::size_t>(i) % forest.tops.size()];
    const double bend = 8 * random.uniform(0.01, 0.05); // of a shallow catenary: 8 sag / span
    const double span = (to - from).head<2>().norm();
    std::vector<Vector3d> places;
    for (int k = 0; k <= edges; ++k) {
      const double share = static_cast<double>(k) / edges;
      places.emplace_back((1 - share) * from + share * to);
      places.back().z() += span / bend * (std::cosh(bend * (share - 0.5)) - std::cosh(bend / 2));
    }
    addLine(forest, places, options.wireRadius * options.growth.height, PlotPart::wire);
  }
}

/// Ground as from the stations: where it is seen.
void addGround(SimulatedPlot& plot, const PlotForest& forest, const PlotGround& ground,
               const std::vector<Vector3d>& stations, double halfSide, Eigen::Index wanted,
               double noise, std::uint64_t seed, const Progress& progress) {
  const WoodIndex wood(woodOf(forest.skeleton));
  const Eigen::Index most = 500 * wanted;
  std::vector<std::optional<Vector3d>> seen;
  for (Eigen::Index from = 0; from < most && wanted > 0; from += wanted) {
    seen.assign(static_cast<std::size_t>(wanted), std::nullopt);
    parallelFor(
        wanted,
        [&](Eigen::Index i) {
          CountedRandom random(seed, static_cast<std::uint64_t>(from + i));
          const auto count = static_cast<double>(stations.size());
          const Vector3d& station = stations[std::min(
              static_cast<std::size_t>(count * random.uniform()), stations.size() - 1)];
          const double away = 3 * halfSide * random.uniform();
          const double angle = 2 * pi * random.uniform();
          const double x = station.x() + away * std::cos(angle);
          const double y = station.y() + away * std::sin(angle);
          if (std::abs(x) > halfSide || std::abs(y) > halfSide) return;
          const Vector3d place(x, y, ground.at(x, y));
          const Vector3d beam = place - station;
          const double range = beam.norm();
          if (range == 0 || wood.firstHit({station, beam / range}, range)) return;
          seen[static_cast<std::size_t>(i)] = place + Vector3d(0, 0, noise * random.normal());
        },
        progress);
    Eigen::Index left = wanted - static_cast<Eigen::Index>(plot.points.positions.size());
    for (const auto& place : seen) {
      if (!place) continue;
      if (left-- <= 0) return;
      plot.points.positions.push_back(*place);
      plot.points.intensities.push_back(0.5F);
      plot.truth.push_back({.part = PlotPart::ground});
    }
  }
}

} // namespace

SimulatedPlot simulatePlot(const PlotOptions& options, std::uint64_t seed,
                           const Progress& progress) {
  check(options);
  Random random(seed + 77);
  const PlotGround ground(options, random);
  const std::vector<Eigen::Vector2d> places = placesInRows(options, random);
  PlotForest forest;
  addPlants(forest, options, ground, places, seed, random, progress.part(0, 0.4));
  double halfSide = 0.8 * options.growth.height;
  for (const Eigen::Vector2d& place : places)
    halfSide = std::max(halfSide, place.cwiseAbs().maxCoeff() + 0.8 * options.growth.height);
  addPoles(forest, options, ground, places, halfSide, random);
  addWires(forest, options, ground, halfSide, random);
  ScannerOptions scanner = options.scanner;
  const auto onGround = static_cast<Eigen::Index>(
      std::round(options.groundShare * static_cast<double>(scanner.points)));
  scanner.points = std::max<Eigen::Index>(scanner.points - onGround, 10);
  SimulatedScan scanned = scan(forest.skeleton, scanner, seed, progress.part(0.4, 0.8));
  SimulatedPlot plot{.points = {}, .truth = {}, .plants = forest.plants, .bases = forest.bases};
  const double noise = scanner.rangeNoise.value_or(options.growth.height / 2500);
  addGround(plot, forest, ground, scanned.stations, halfSide, onGround, noise, seed + 5,
            progress.part(0.8, 1));
  for (std::size_t i = 0; i < scanned.points.positions.size(); ++i) {
    plot.points.positions.push_back(scanned.points.positions[i]);
    plot.points.intensities.push_back(scanned.points.intensities[i]);
    const std::optional<NodeId>& node = scanned.nodes[i];
    plot.truth.push_back(node ? forest.parts[indexOf(*node)] : PlotPoint{});
  }
  progress.update(1);
  return plot;
}

} // namespace espalier
