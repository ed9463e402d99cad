#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/simulate/foliage.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A simulated scan, and where each of its points is from.
struct SimulatedScan {
  RawPoints points; // frame of the plant; intensities in [0, 1]
  /// Per point: whose edge it lies on; none if that is foliage, or if it is stray.
  std::vector<std::optional<NodeId>> nodes;
  std::vector<Organ> organs;             // per point; that of a stray one means nothing
  std::vector<Eigen::Vector3d> stations; // [L], where the scanner stood; none if it did not
  std::vector<StationIndex> stationOf;   // per point: from which of them; none without stations
  double angularStep = 0;                // between beams [rad], 0 without stations
  std::vector<Blade> blades;             // the needles and leaves there were
  std::vector<EdgeSolid> petioles;       // likewise
};

/// Extent below: the larger of height and width of the plant.
struct ScannerOptions {
  Eigen::Index points = 100'000;   // wanted of all stations together, in [10, 10^8]
  int stations = 4;                // evenly around the plant, in [1, 100]
  double distance = 1.5;           // of the stations from its middle, in extents, in [0.6, 100]
  double elevation = 0.35;         // of the stations above its foot, in heights, in [-10, 10]
  std::optional<double> azimuth;   // of the first station [rad]; none: any
  std::vector<Eigen::Vector3d> at; // [L], stations at these places instead

  // Standard deviations [L], >= 0; none: extent / 2500.
  std::optional<double> rangeNoise;   // along the beam
  std::optional<double> misalignment; // of the scan of a station, in each coordinate

  double rangeNoiseInSteps = 0; // noise in spacings of the beams at that range, added to the other
  double angularNoise = 0.1;    // standard deviation of beam directions, in steps, in [0, 10]
  double beamWidth = 0.5;       // diameter of a beam, in steps, in [0, 3]; 0: no mixed pixels
  double grazingLoss = 0.5;     // share of echoes lost where beams graze, in [0, 1]
  double strayShare = 0.001;    // of points that lie on nothing, in [0, 0.5]
  int clumps = 0;               // of leaves that hid the wood and were cleaned away, in [0, 1000]
  double clumpRadius = 0.05;    // in extents, in [0, 1]
  Foliage foliage;              // in the scan, not in the structure
};

/// What a laser scanner would have measured of a plant.
///
/// From each station beams go out in even steps of azimuth and elevation. Each returns the first
/// wood it meets, so that twigs behind others are missing, near wood has more points than far wood,
/// and what no station sees is not there. A beam has a width: one that grazes an edge may return a
/// range between the two surfaces that it meets, and thin twigs look thicker than they are.
/// Foliage is met and hides what is behind it, but its points lie on no edge. The angular step
/// follows from the number of points wanted, which is met within a few percent.
///
/// @param plant  with radii; see woodOf for the surface it stands for
/// @throws Error     if a node has no radius, an option is out of its range, or no beam hits
/// @throws Cancelled if `progress` asks to stop
/// Deterministic for any number of threads. Time O(B log N) for B beams and N nodes; a plant fills
/// about a tenth of what is scanned, so that B is about ten times the number of points.
[[nodiscard]] SimulatedScan scan(const Skeleton& plant, const ScannerOptions& options,
                                 std::uint64_t seed, const Progress& progress = {});

/// The points of each station by themselves, in the frame of the plant, each with its station.
[[nodiscard]] std::vector<RawPoints> pointsByStation(const SimulatedScan& scan);

} // namespace espalier
