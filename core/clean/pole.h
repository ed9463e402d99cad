#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/clean/standing_points.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

struct PoleOptions {
  /// [L] how far from its wall a point is of it still: the larger of the two
  Length tolerance = Rule{.spacings = 0.75, .heights = 0.0018};
  Length noise = scatters(6);
  Length mostRadius = heights(0.02); // [L]
  Length reach = heights(0.06);      // [L] around the place, in which the cylinder is sought
  Length gap = heights(0.04);        // [L] it goes on over gaps up to this
  double mostLean = 0.35;            // from upright [rad]
  Length leastLength = heights(0.2); // [L] of those that are searched for
  int trials = 400;                  // cylinders tried at a place, >= 1
  std::uint64_t seed = 1;

  [[nodiscard]] double width() const { return std::max<double>(tolerance, noise); } // [L]
};

/// Lengths by rules become those for a plant of this scale.
[[nodiscard]] PoleOptions resolved(PoleOptions options, const PlantScale& scale);

/// A straight pole, stake or post.
struct Pole {
  Eigen::Vector3d foot = Eigen::Vector3d::Zero(); // [L], lower end of its axis
  Eigen::Vector3d top = Eigen::Vector3d::Zero();  // [L], upper end
  double radius = 0;                              // [L]
  double error = 0;                               // root mean square distance to its wall [L]
  std::vector<Eigen::Index> points;               // ascending: on its wall, and within
};

/// The pole at a place: the cylinder that most points around the place lie on, as far up and down
/// as it goes on without a gap.
///
/// Cylinders are drawn by chance, from two points and their normals (any lean), or from three
/// points and a direction; the one with most points on its wall and fewest within is fitted by
/// least squares, then followed and fitted again until it grows no longer.
///
/// @param points  3 x N, z up [L]
/// @param place   on or near the pole [L], in the frame of the points
/// @return none if no cylinder of that radius and lean stands there; a trunk is one, too
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N + trials m) for m points around the place, m <= 3000.
/// Source: R. Schnabel, R. Wahl, R. Klein, "Efficient RANSAC for point-cloud shape detection",
/// Computer Graphics Forum 26, 2007; fit: core/radius/cylinder_fit.h.
[[nodiscard]] std::optional<Pole> poleAt(const Eigen::Matrix3Xf& points,
                                         const Eigen::Vector3d& place, const PoleOptions& options,
                                         const Progress& progress = {});

/// The same in a scan: the points of the pole at a place of the file, none if there is none.
/// @param leftOut  are not looked at
/// @param scale    that lengths by rules follow from
[[nodiscard]] PointSet polePointsAt(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                                    const PlantScale& scale, const Eigen::Vector3d& place,
                                    const PoleOptions& options = {}, const Progress& progress = {});

/// All poles of a scan, the one of most points first.
///
/// Sought where points stand above each other with nothing around them over 40 % of `leastLength`.
/// A pole is at least `leastLength` long, straight, as thick above as below and ends free at
/// both ends: so trunks, which taper and go on, are none.
/// @param points  3 x N, z up [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N).
[[nodiscard]] std::vector<Pole> polesIn(const Eigen::Matrix3Xf& points, const PoleOptions& options,
                                        const Progress& progress = {});

} // namespace espalier
