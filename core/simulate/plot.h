#pragma once

#include "core/base/progress.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

enum class PlotPart : std::uint8_t { plant, ground, pole, wire, stray };

/// What a point of a plot is of.
struct PlotPoint {
  PlotPart part = PlotPart::stray;
  std::uint32_t plant = 0; // of plants: which, from 1
  bool operator==(const PlotPoint&) const = default;
};

/// Heights below: of the plants as asked for.
struct PlotOptions {
  GrowthOptions growth;      // of each plant
  int plants = 3;            // in [1, 1000]
  double heightSpread = 0.2; // of the heights of plants about that asked for, in [0, 0.9]
  double spacing = 1;        // between plants of a row and between rows, in heights, in [0.05, 100]
  double slope = 0.2;        // of the ground [rad], in [0, 1]
  double bumps = 0.02;       // how high the ground is uneven, in heights, in [0, 1]
  double groundShare = 0.4;  // of the points, in [0, 0.95]
  int poles = 1;             // in [0, 100]; each in the middle between plants
  double poleHeight = 0.8;   // in heights, in [0.01, 10]
  double poleRadius = 0.006; // in heights, in (0, 1]
  int wires = 1; // in [0, 100]; each from the top of a pole, if there is one, over the plot
  double wireRadius = 0.002; // in heights, in (0, 1]
  ScannerOptions scanner;    // points: of all; strays: in the box of all
};

/// A plot, and what each of its points is of.
struct SimulatedPlot {
  RawPoints points;
  std::vector<PlotPoint> truth;       // one per point
  std::vector<Skeleton> plants;       // in the frame of the points
  std::vector<Eigen::Vector3d> bases; // [L], of the plants
};

/// What a laser scanner would have measured of several plants on a slope, with poles and wires.
///
/// Plants of one kind stand in rows, a bit off their places, each turned and as high as by chance.
/// Plants, poles and wires are scanned together (laser_scanner.h) and hide each other. The ground
/// is sampled as from the same stations: its points get fewer with distance, and are missing where
/// something stands before them; it hides nothing itself.
///
/// @throws Error     if an option is out of its range, or no beam hits
/// @throws Cancelled if `progress` asks to stop
/// Deterministic for any number of threads.
[[nodiscard]] SimulatedPlot simulatePlot(const PlotOptions& options, std::uint64_t seed,
                                         const Progress& progress = {});

} // namespace espalier
