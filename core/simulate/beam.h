#pragma once

#include "core/base/counted_random.h"
#include "core/simulate/foliage.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/piece_tree.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// The part of the sphere around a station in which there may be wood [rad].
struct ScanWindow {
  Eigen::Vector3d station;                         // [L]
  double azimuth = 0;                              // of the first beam
  double elevation = 0;                            // of the lowest beam
  double width = 0;                                // in azimuth
  double height = 0;                               // in elevation
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); // [L], how far its scan is out of place
};

[[nodiscard]] ScanWindow windowOf(const Eigen::Vector3d& station,
                                  const Eigen::AlignedBox3d& bounds);

/// Leaves that hid the wood.
struct LeafClump {
  Eigen::Vector3d center; // [L]
  double radius = 0;      // [L]
};

/// What the beams of one scan go through.
struct ScanScene {
  const WoodIndex& wood; // with short shoots
  const PieceTree<Blade>& blades;
  const ScannerOptions& options;
  std::vector<LeafClump> clumps;
  double extent = 0;     // [L]
  double rangeNoise = 0; // [L]
};

struct Echo {
  Eigen::Vector3d position;   // [L]
  float intensity = 0;        // in [0, 1]
  std::optional<NodeId> node; // whose edge it lies on; none: foliage
  Organ organ = Organ::wood;
};

/// What comes back of the beam sent to this azimuth and elevation, if anything does.
/// @param step  angle between beams [rad]
[[nodiscard]] std::optional<Echo> echoOf(const ScanScene& scene, const Eigen::Vector3d& station,
                                         double azimuth, double elevation, double step,
                                         CountedRandom random);

} // namespace espalier
