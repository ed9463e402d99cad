#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/clean/standing_points.h"

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <vector>

namespace espalier {

struct WireOptions {
  /// [L] how far from its curve a point is of it still: the larger of the two
  Length tolerance = Rule{.spacings = 1, .heights = 0.0025};
  Length noise = scatters(6);
  Length gap = heights(0.1);         // [L] it goes on over gaps up to this
  double mostSag = 0.2;              // of the span, in [0, 1]
  Length leastLength = heights(0.5); // [L] of those that are searched for

  [[nodiscard]] double width() const { return std::max<double>(tolerance, noise); } // [L]
};

/// Lengths by rules become those for a plant of this scale.
[[nodiscard]] WireOptions resolved(WireOptions options, const PlantScale& scale);

/// A wire, rope or hose that hangs between two ends.
struct Wire {
  Eigen::Vector3d from = Eigen::Vector3d::Zero(); // [L], its ends
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double sag = 0;                   // [L], greatest depth below the line from end to end
  double error = 0;                 // root mean square distance of its points to the curve [L]
  double filled = 0;                // share of its length that has points, [0, 1]
  std::vector<Eigen::Index> points; // ascending
};

/// The wire through two places: the catenary in the upright plane through them that most of the
/// length between them has points on, fitted by least squares, and followed beyond both places as
/// far as points go on.
///
/// @param points  3 x N, z up [L]
/// @param a, b    on or near the wire, in the frame of the points [L]; not above each other
/// @return none if less than half of the length between the places has points on a catenary
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N).
/// Source: the catenary as power lines are fitted, e.g. Y. Jwa, G. Sohn, "A piecewise catenary
/// curve model growing for 3D power line reconstruction", PE&RS 78, 2012; weights as in
/// core/radius/cylinder_fit.h.
[[nodiscard]] std::optional<Wire> wireBetween(const Eigen::Matrix3Xf& points,
                                              const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                              const WireOptions& options,
                                              const Progress& progress = {});

/// The same in a scan: the points of the wire through two places of the file, none if there is
/// none.
/// @param leftOut  are not looked at
/// @param scale    that lengths by rules follow from
[[nodiscard]] PointSet wirePointsBetween(const PointCloud& cloud, const PointSet& leftOut,
                                         UpAxis up, const PlantScale& scale,
                                         const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const WireOptions& options = {},
                                         const Progress& progress = {});

/// All wires of a scan, the one of most points first.
///
/// Starts from places whose surroundings are a thin line, joined where they go on straight; each
/// such line is fitted and followed. A wire is at least `leastLength` long, has points on over 70 %
/// of it, and hangs free over half of it: so branches, which thicken and fork, are none.
/// @param points  3 x N, z up [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N).
[[nodiscard]] std::vector<Wire> wiresIn(const Eigen::Matrix3Xf& points, const WireOptions& options,
                                        const Progress& progress = {});

} // namespace espalier
