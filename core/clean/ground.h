#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/clean/standing_points.h"

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace espalier {

struct GroundOptions {
  Length cell = heights(0.02);       // [L] of the cloth
  Length tolerance = heights(0.008); // [L] points not higher than this above it are of the ground
  Length noise = scatters(6);        // [L] nor are those this high where the scan scatters wide
  int rigidness = 2;                 // how often each step stiffens the cloth, in [1, 10]
  int iterations = 500;              // at most, >= 1
  bool followSlopes = true;          // pulls the cloth down to what lies near on steep ground

  [[nodiscard]] double width() const { return std::max<double>(tolerance, noise); } // [L]
};

[[nodiscard]] GroundOptions resolved(GroundOptions options, const PlantScale& scale);

/// The height of the ground, on an even grid; without nodes if there were no points.
struct GroundSurface {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero(); // [L], of the first node
  double cell = 1;                                  // [L]
  Eigen::MatrixXd heights;                          // [L], node (i, j) at corner + cell (i, j)

  /// Between nodes linear; beyond the grid as at its edge. pre: it has nodes
  [[nodiscard]] double at(double x, double y) const;
};

/// The ground below plants by a cloth that is laid on the points from below.
///
/// The plane through the lowest points of the cells is taken out first. Particles of a cloth, one
/// per cell, then fall in the scan turned over, bound to their neighbors, until the points hold
/// them; the lowest points of a cell that at least two more lie close above, in dense scans a
/// hundredth of what nine cells hold, count, so that strays below the ground hold nothing.
///
/// @param points  3 x N, z up [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N + iterations C) for C cells, of which there are 4 million at most:
/// cells become larger otherwise.
/// Source: W. Zhang et al., "An easy-to-use airborne LiDAR data filtering method based on cloth
/// simulation", Remote Sensing 8(6), 2016. Differs: the plane, without which a cloth does not reach
/// the low end of a steep slope; the strays; lengths follow from the plant.
[[nodiscard]] GroundSurface groundBelow(const Eigen::Matrix3Xf& points,
                                        const GroundOptions& options,
                                        const Progress& progress = {});

/// How high each point lies above the ground [L]. O(N).
[[nodiscard]] std::vector<float> heightsAbove(const GroundSurface& ground,
                                              const Eigen::Matrix3Xf& points);

} // namespace espalier
